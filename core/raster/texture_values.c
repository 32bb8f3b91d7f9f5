/* raster/texture_values.c: 1/w, u/w and v/w at the vertices. Called by texture_perspective.c and
 * texture_small.c. See texture_values.h and texture_perspective.c. */
#include "texture_values.h"

int32_t etch_texture_inverses(int32_t q[3], const struct etch_texture_vertex *const vertex[3])
{
    uint8_t zeros[3], most = 0;
    int32_t least = INT32_MAX;

    for (uint8_t i = 0; i < 3; i++) {
        const uint32_t w = vertex[i]->w != 0 ? vertex[i]->w : 1;

        zeros[i] = etch_leading_zeros(w);
        most = zeros[i] > most ? zeros[i] : most;
        q[i] = etch_reciprocal_q62(w << zeros[i]);
    }
    for (uint8_t i = 0; i < 3; i++) {
        q[i] >>= most - zeros[i] < 30 ? most - zeros[i] + 1 : 31;
        q[i] = q[i] > 0 ? q[i] : 1;
        least = q[i] < least ? q[i] : least;
    }
    return least;
}

int8_t etch_texture_numerators(struct etch_perspective_axis *a, uint32_t value[3],
                               const etch_q16 c[3], const int32_t q[3])
{
    etch_q16 least = c[0], most = c[0];

    for (uint8_t i = 1; i < 3; i++) {
        least = c[i] < least ? c[i] : least;
        most = c[i] > most ? c[i] : most;
    }
    const uint32_t span = etch_wrap_sub((uint32_t)most, (uint32_t)least);
    const uint32_t half = (span >> 1) + (span & 1); /* |c - middle| <= half < 2^bits */
    const int8_t bits = (int8_t)(32 - etch_leading_zeros(half)),
                 e = bits > 2 ? (int8_t)(bits + 1) : 3;

    a->middle = etch_wrap_add((uint32_t)least, half);
    a->least = (int32_t)etch_wrap_sub((uint32_t)least, a->middle);
    a->most = (int32_t)etch_wrap_sub((uint32_t)most, a->middle);
    a->exponent = (int8_t)(e - 34);
    for (uint8_t i = 0; i < 3; i++) {
        const int32_t offset = (int32_t)etch_wrap_sub((uint32_t)c[i], a->middle);

        value[i] = (uint32_t)((int32_t)(etch_mul_s32(offset, q[i]) >> e) + (INT32_C(1) << 29));
    }
    return e;
}
