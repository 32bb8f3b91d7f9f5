/* vertex/rotate.c: rotation matrices. Called by the application. See matrix.h. */
#include "../base/trig.h"
#include "matrix.h"
#include "vector.h"

/* The plane from axis `a` to axis `b` turned by `angle`. */
static void rotate_plane(struct etch_matrix *m, int a, int b, uint16_t angle)
{
    const etch_q16 sine = etch_sin_q16(angle);

    etch_matrix_identity(m);
    m->m[a][a] = m->m[b][b] = etch_cos_q16(angle);
    m->m[b][a] = sine;
    m->m[a][b] = -sine;
}

void etch_matrix_rotate_x(struct etch_matrix *m, uint16_t angle)
{
    rotate_plane(m, 1, 2, angle);
}

void etch_matrix_rotate_y(struct etch_matrix *m, uint16_t angle)
{
    rotate_plane(m, 2, 0, angle);
}

void etch_matrix_rotate_z(struct etch_matrix *m, uint16_t angle)
{
    rotate_plane(m, 0, 1, angle);
}

static int64_t mul_q30(int64_t a, int64_t b)
{
    return (a * b + (INT64_C(1) << 29)) >> 30;
}

enum etch_status etch_matrix_rotate(struct etch_matrix *m, uint16_t angle,
                                    const struct etch_vector *axis)
{
    const int64_t along[3] = {axis->x, axis->y, axis->z};
    const int32_t sine = etch_sin_q30(angle);
    const int32_t cosine = etch_cos_q30(angle);
    int32_t u[3];

    if (etch_vector_unit_q30(u, along) != ETCH_OK)
        return ETCH_EINVAL;
    etch_matrix_identity(m);
    /* cos * I + sin * [u]x + (1 - cos) * u u^T (O. Rodrigues, 1840). Errors in 2.30: about ten
     * units, a thousandth of the final rounding. */
    for (int i = 0; i < 3; i++) {
        const int j = i < 2 ? i + 1 : 0;
        const int k = 3 - i - j;
        const int64_t rest = (INT64_C(1) << 30) - cosine;
        const int64_t same = cosine + mul_q30(rest, mul_q30(u[i], u[i]));
        const int64_t mixed = mul_q30(rest, mul_q30(u[i], u[j]));
        const int64_t turn = mul_q30(sine, u[k]);

        m->m[i][i] = (etch_q16)((same + 8192) >> 14);
        m->m[i][j] = (etch_q16)((mixed - turn + 8192) >> 14);
        m->m[j][i] = (etch_q16)((mixed + turn + 8192) >> 14);
    }
    return ETCH_OK;
}
