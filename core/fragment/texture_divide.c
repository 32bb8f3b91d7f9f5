/* fragment/texture_divide.c: the divide of perspective. Called by the kernels in perspective, every
 * 16 pixels or every pixel. See texture_divide.h. */
#include "texture_divide.h"

/* a r / 2^32 less 0 .. 3, for |a| < 2^30, r < 2^31: the product of the low halves is left out, less
 * than one of 2^28 units. */
ETCH_INLINE int32_t high_product(int32_t a, int32_t r)
{
    const int32_t ah = a >> 16, al = a & 0xFFFF, rh = r >> 16, rl = r & 0xFFFF;

    return ah * rh + (ah * rl >> 16) + (al * rh >> 16);
}

/* m 2^s, to the left modulo 2^32; s = -31 .. 30. */
ETCH_INLINE int32_t scaled(int32_t m, int32_t s)
{
    return s <= 0 ? m >> -s : (int32_t)etch_wrap_up((uint32_t)m, (uint8_t)s);
}

/* With d 2^-zeros the denominator and r = 2^62 / d, numerator / denominator = numerator r 2^(zeros
 * - 62), of which the high product takes 32. The exponent holds the other 30 and the
 * four bits less than 16.16. */
void etch_texel_divide(struct etch_texel_offset *out, const struct etch_perspective_planes *c,
                       const struct etch_texel_ratio *at)
{
    uint32_t d = (uint32_t)(at->d < c->least ? c->least : at->d);
    int32_t zeros = 0;

    do /* at least once, and to three times where w varies little */
        d <<= 1, zeros++;
    while ((int32_t)d >= 0);
    const int32_t r = etch_reciprocal_q62(d);

    out->u = scaled(high_product(at->u, r), zeros + c->u.exponent);
    out->v = scaled(high_product(at->v, r), zeros + c->v.exponent);
}
