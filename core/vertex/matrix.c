/* vertex/matrix.c: the simple matrices and the product. Called by the application once a frame
 * or object. See matrix.h. */
#include "matrix.h"

void etch_matrix_identity(struct etch_matrix *m)
{
    etch_matrix_scale(m, ETCH_Q16_ONE, ETCH_Q16_ONE, ETCH_Q16_ONE);
}

void etch_matrix_translate(struct etch_matrix *m, etch_q16 x, etch_q16 y, etch_q16 z)
{
    etch_matrix_identity(m);
    m->m[0][3] = x;
    m->m[1][3] = y;
    m->m[2][3] = z;
}

void etch_matrix_scale(struct etch_matrix *m, etch_q16 x, etch_q16 y, etch_q16 z)
{
    for (int row = 0; row < 4; row++)
        for (int column = 0; column < 4; column++)
            m->m[row][column] = 0;
    m->m[0][0] = x;
    m->m[1][1] = y;
    m->m[2][2] = z;
    m->m[3][3] = ETCH_Q16_ONE;
}

/* Row `row` of a times column `column` of b, rounded once. Four products of 2^62 do not fit 64
 * bits, so whole and fraction parts are summed apart: |whole| <= 2^48, fraction < 2^18. */
static int64_t entry(const struct etch_matrix *a, const struct etch_matrix *b, int row, int column)
{
    int64_t whole = 0;
    int32_t fraction = 32768;

    for (int i = 0; i < 4; i++) {
        const int64_t product = etch_mul_s32(a->m[row][i], b->m[i][column]);

        whole += product >> 16;
        fraction += (int32_t)(product & 0xFFFF);
    }
    return whole + (fraction >> 16);
}

enum etch_status etch_matrix_multiply(struct etch_matrix *m, const struct etch_matrix *a,
                                      const struct etch_matrix *b)
{
    struct etch_matrix product;

    for (int row = 0; row < 4; row++) {
        for (int column = 0; column < 4; column++) {
            const int64_t v = entry(a, b, row, column);

            product.m[row][column] = etch_saturate_s32(v);
            if (product.m[row][column] != v)
                return ETCH_ERANGE;
        }
    }
    *m = product;
    return ETCH_OK;
}
