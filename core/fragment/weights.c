/* fragment/weights.c: the weights of a triangle's vertices at a pixel, in perspective. Called by
 * source_perspective.c for every pixel. See weights.h.
 *
 * Numbers are mantissa 2^exponent. Of e < 2^50 and 1/w the leading 31 bits are kept, of their
 * product 28 at least; terms are brought to the greatest exponent, which drops less than a unit of
 * 2^28 of each, and their sum D < 3 2^30 divides by its reciprocal, 2^-27.9 off.
 */
#include "weights.h"
#include "../base/texture.h"

struct term {
    int32_t m; /* 0, or 2^28 .. 2^30 */
    int8_t exponent;
};

static int64_t edge_at(const struct etch_weight_edge *e, int32_t x_q8, int32_t y_q8)
{
    return etch_mul_s32(e->dx, y_q8 - e->y) - etch_mul_s32(e->dy, x_q8 - e->x);
}

/* e / w */
static struct term term_of(int64_t e, int32_t inverse, uint8_t up)
{
    struct term t = {0, 0};

    if (e <= 0)
        return t;
    const uint32_t high = (uint32_t)((uint64_t)e >> 32), low = (uint32_t)(e & UINT32_MAX);
    const uint8_t zeros = etch_leading_zeros(high != 0 ? high : low);
    /* the leading bit to bit 30 */
    const uint32_t m = high != 0 ? (uint32_t)((uint64_t)e >> (33 - zeros)) : low << zeros >> 1;

    t.m = etch_mul_high((int32_t)m, inverse);
    t.exponent = (int8_t)((high != 0 ? 32 : 0) - zeros + up);
    return t;
}

/* The mantissa in units of 2^exponent, which is not below the term's own unless the term is 0. */
static uint32_t brought_to(struct term t, int8_t exponent)
{
    const int16_t down = (int16_t)(exponent - t.exponent);

    return t.m != 0 && down < 31 ? (uint32_t)(t.m >> down) : 0;
}

struct etch_weight_pair etch_weights_at(const struct etch_weights *w, int16_t x, int16_t y)
{
    const int32_t x_q8 = (int32_t)x * 256 + 128, y_q8 = (int32_t)y * 256 + 128;
    const int64_t e1 = edge_at(&w->edge[0], x_q8, y_q8), e2 = edge_at(&w->edge[1], x_q8, y_q8);
    const struct term t[3] = {term_of(w->area - e1 - e2, w->inverse[0], w->up[0]),
                              term_of(e1, w->inverse[1], w->up[1]),
                              term_of(e2, w->inverse[2], w->up[2])};
    struct etch_weight_pair pair = {0, 0};
    int8_t most = INT8_MIN;

    for (uint8_t i = 0; i < 3; i++)
        if (t[i].m != 0 && t[i].exponent > most)
            most = t[i].exponent;
    if (most == INT8_MIN) /* not inside the triangle */
        return pair;
    const uint32_t m1 = brought_to(t[1], most), m2 = brought_to(t[2], most);
    const uint32_t d = brought_to(t[0], most) + m1 + m2;
    const uint8_t zeros = etch_leading_zeros(d); /* 0 .. 3 */
    const int32_t r = etch_reciprocal_q62(d << zeros);

    /* (m 2^zeros / 2) (2^62 / (d 2^zeros)) / 2^32 = m / d 2^29 */
    pair.one = etch_mul_high((int32_t)(m1 << zeros >> 1), r);
    pair.two = etch_mul_high((int32_t)(m2 << zeros >> 1), r);
    return pair;
}
