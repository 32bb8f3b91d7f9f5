/* vertex/look_at.c: the camera's matrix. Called by the application once a frame. See matrix.h. */
#include "matrix.h"
#include "vector.h"

/* Row `row` of the camera matrix from a unit vector times `sign`; false if its last entry does
 * not fit. */
static bool set_row(struct etch_matrix *m, int row, const int32_t unit_q30[3], int32_t sign,
                    const struct etch_vector *eye)
{
    int64_t offset = 0; /* |offset| <= 3 * 2^16 * 2^31 */

    for (int i = 0; i < 3; i++)
        m->m[row][i] = (sign * unit_q30[i] + 8192) >> 14;
    offset -= etch_mul_s32(m->m[row][0], eye->x);
    offset -= etch_mul_s32(m->m[row][1], eye->y);
    offset -= etch_mul_s32(m->m[row][2], eye->z);
    offset = (offset + 32768) >> 16;
    m->m[row][3] = etch_saturate_s32(offset);
    return m->m[row][3] == offset;
}

enum etch_status etch_matrix_look_at(struct etch_matrix *m, const struct etch_vector *eye,
                                     const struct etch_vector *target, const struct etch_vector *up)
{
    int64_t view[3] = {(int64_t)target->x - eye->x, (int64_t)target->y - eye->y,
                       (int64_t)target->z - eye->z};
    int64_t above[3] = {up->x, up->y, up->z};
    int64_t cross[3];
    int32_t forward[3], right[3], upward[3];
    struct etch_matrix camera;

    if (etch_vector_unit_q30(forward, view) != ETCH_OK)
        return ETCH_EINVAL;
    /* view and up to 30 bits, exact unless longer: the cross product is as good as they are. */
    etch_vector_normalize_range(view);
    etch_vector_normalize_range(above);
    const int32_t v[3] = {(int32_t)view[0], (int32_t)view[1], (int32_t)view[2]};
    const int32_t a[3] = {(int32_t)above[0], (int32_t)above[1], (int32_t)above[2]};
    const int64_t parallel = INT64_C(1) << 32; /* |v x a| > 2^58 * sine of their angle */

    etch_vector_cross(cross, v, a);
    if (cross[0] < parallel && cross[0] > -parallel && cross[1] < parallel &&
        cross[1] > -parallel && cross[2] < parallel && cross[2] > -parallel)
        return ETCH_EINVAL;
    (void)etch_vector_unit_q30(right, cross);
    etch_vector_cross(cross, right, forward);
    (void)etch_vector_unit_q30(upward, cross);

    etch_matrix_identity(&camera);
    if (!set_row(&camera, 0, right, 1, eye) || !set_row(&camera, 1, upward, 1, eye) ||
        !set_row(&camera, 2, forward, -1, eye))
        return ETCH_ERANGE;
    *m = camera;
    return ETCH_OK;
}
