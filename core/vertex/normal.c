/* vertex/normal.c: normals by the inverse transpose. The matrix is set up by the application once a
 * draw, normals are transformed by draw/mesh_shaded once a vertex. See normal.h. */
#include "normal.h"
#include "vector.h"

/* The cross products of rows whose entries are below 2^30: a factor on all of them is free, so one
 * bit is dropped where a row has 31. */
static void cofactors(int64_t cofactor[3][3], const struct etch_matrix *model)
{
    int32_t m[3][3], most = 0;

    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            most |= model->m[i][j] ^ model->m[i][j] >> 31;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            m[i][j] = most >> 30 != 0 ? model->m[i][j] >> 1 : model->m[i][j];
    for (int i = 0; i < 3; i++)
        etch_vector_cross(cofactor[i], m[i < 2 ? i + 1 : 0], m[i > 0 ? i - 1 : 2]);
}

/* v 2^-down, or 2^-down more exactly up, rounded. */
static int16_t scaled(int64_t v, int8_t down)
{
    return (int16_t)(down > 0 ? (v + (INT64_C(1) << (down - 1))) >> down
                              : v * (INT64_C(1) << -down));
}

/* Whether the determinant is negative: row 0 times its cofactors, by digits of 20 bits so that
 * nothing is lost. */
static bool is_mirror(const struct etch_matrix *model, const int64_t cofactor[3])
{
    int64_t sum[3] = {0, 0, 0}; /* below 3 * 2^53 */

    for (int j = 0; j < 3; j++) {
        const int64_t m = model->m[0][j];

        sum[0] += (cofactor[j] & 0xFFFFF) * m;
        sum[1] += (cofactor[j] >> 20 & 0xFFFFF) * m;
        sum[2] += (cofactor[j] >> 40) * m;
    }
    sum[1] += sum[0] >> 20;
    return sum[2] + (sum[1] >> 20) < 0;
}

/* Cofactors are the inverse transpose times the determinant, which a mirror makes negative. */
enum etch_status etch_normal_matrix_init(struct etch_normal_matrix *n,
                                         const struct etch_matrix *model)
{
    int64_t cofactor[3][3];
    uint64_t most = 0;
    int8_t down = 0;

    cofactors(cofactor, model);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            most |= (uint64_t)(cofactor[i][j] < 0 ? -cofactor[i][j] : cofactor[i][j]);
    if (most == 0)
        return ETCH_EINVAL;

    const bool mirror = is_mirror(model, cofactor[0]);

    for (; most >= UINT64_C(1) << 14; most >>= 1)
        down++;
    for (; most < UINT64_C(1) << 13; most *= 2)
        down--;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            n->m[i][j] = scaled(mirror ? -cofactor[i][j] : cofactor[i][j], down);
    return ETCH_OK;
}

/* Sums below 3 * 2^14 * 2^7. */
void etch_normal_transform(const struct etch_normal_matrix *n, const int8_t normal[3],
                           int16_t unit[3])
{
    int32_t v[3];

    for (int i = 0; i < 3; i++)
        v[i] = etch_mul_s16(n->m[i][0], normal[0]) + etch_mul_s16(n->m[i][1], normal[1]) +
               etch_mul_s16(n->m[i][2], normal[2]);
    (void)etch_unit_q14(unit, v);
}
