/* vertex/cut.c: new vertices of clipped polygons, exact but for one rounding. Called by clip.c.
 * See cut.h. */
#include "cut.h"

void etch_cut_corner(struct cut_corner *corner, const struct etch_clip_vertex *v, uint8_t ends)
{
    const struct cut_corner c = {{v->x, v->y, v->z, v->w},
                                 {UINT32_C(1) << 31, -31},
                                 {v->r, v->g, v->b, v->a},
                                 ends};
    *corner = c;
}

void etch_cut_vertex(struct etch_clip_vertex *v, const struct cut_corner *corner)
{
    v->x = corner->v[0];
    v->y = corner->v[1];
    v->z = corner->v[2];
    v->w = corner->v[3];
    v->r = corner->rgba[0];
    v->g = corner->rgba[1];
    v->b = corner->rgba[2];
    v->a = corner->rgba[3];
}

/* v * 2^exponent, cut off to 32 bits. */
static struct cut_scale scale_from(uint64_t v, int16_t exponent)
{
    struct cut_scale s = {0, INT16_MIN};

    if (v == 0)
        return s;
    for (; v >= UINT64_C(1) << 32; v >>= 1)
        exponent++;
    for (; v < UINT64_C(1) << 31; v <<= 1)
        exponent--;
    s.mantissa = (uint32_t)v;
    s.exponent = exponent;
    return s;
}

static struct cut_scale scale_times(struct cut_scale a, uint64_t factor)
{
    const struct cut_scale b = scale_from(factor, 0);

    if (b.mantissa == 0)
        return b;
    return scale_from((uint64_t)a.mantissa * b.mantissa, (int16_t)(a.exponent + b.exponent));
}

/* The mantissa of s at a larger or equal exponent. */
static uint32_t scale_align(struct cut_scale s, int16_t exponent)
{
    const int32_t shift = (int32_t)exponent - s.exponent;

    return shift > 31 ? 0 : s.mantissa >> shift;
}

static struct cut_scale scale_sum(struct cut_scale a, struct cut_scale b)
{
    const int16_t e = a.exponent > b.exponent ? a.exponent : b.exponent;

    return scale_from((uint64_t)scale_align(a, e) + scale_align(b, e), e);
}

/* part / whole in 16.16, part <= whole != 0; errs by at most 3 units. */
static int32_t share_q16(struct cut_scale part, struct cut_scale whole)
{
    const uint32_t share = scale_align(part, whole.exponent) / (whole.mantissa >> 16);

    return share < 65536 ? (int32_t)share : 65536;
}

/* sums[] = a * p + b * q, with weights p, q < 2^43, times a common power of two, which is
 * returned. A product has up to 75 bits: the weights' parts above and below 2^16 are summed
 * apart (|high| < 2^59) and put together if they fit. */
static int16_t combine(int64_t sums[4], const int32_t a[4], uint64_t p, const int32_t b[4],
                       uint64_t q)
{
    const int64_t p_high = (int64_t)(p >> 16), p_low = (int64_t)(p & 0xFFFF);
    const int64_t q_high = (int64_t)(q >> 16), q_low = (int64_t)(q & 0xFFFF);
    uint16_t low[4];
    bool fits = true;

    for (int i = 0; i < 4; i++) {
        const int64_t rest = a[i] * p_low + b[i] * q_low; /* below 2^48 */

        sums[i] = a[i] * p_high + b[i] * q_high + (rest >> 16);
        low[i] = (uint16_t)(rest & 0xFFFF);
        fits = fits && sums[i] < INT64_C(1) << 46 && sums[i] > -(INT64_C(1) << 46);
    }
    if (!fits) /* dropping `low` costs 2^-46 of the largest */
        return -16;
    for (int i = 0; i < 4; i++)
        sums[i] = sums[i] * 65536 + low[i];
    return 0;
}

/* v[] = sums[] * 2^shift, rounded to nearest, so that the largest has 30 bits; returns shift. */
static int16_t normalize(int32_t v[4], const int64_t sums[4])
{
    uint64_t size = 0;
    int16_t shift = 0;

    for (int i = 0; i < 4; i++)
        size |= (uint64_t)(sums[i] ^ (sums[i] >> 63));
    for (; size >= UINT64_C(1) << 30; size >>= 1)
        shift--;
    for (; size != 0 && size < UINT64_C(1) << 29; size <<= 1)
        shift++;
    for (int i = 0; i < 4; i++)
        v[i] = shift < 0 ? (int32_t)((sums[i] + (INT64_C(1) << (-shift - 1))) >> -shift)
                         : (int32_t)(sums[i] * (INT64_C(1) << shift));
    return shift;
}

void etch_cut_edge(struct cut_corner *cut, const struct cut_corner *in, int64_t inside,
                   const struct cut_corner *out, int64_t outside)
{
    const uint64_t p = (uint64_t)-outside, q = (uint64_t)inside;
    const struct cut_scale in_scale = scale_times(in->scale, p);
    const struct cut_scale out_scale = scale_times(out->scale, q);
    int64_t sums[4];

    cut->scale = scale_sum(in_scale, out_scale);
    const int32_t share = share_q16(out_scale, cut->scale);
    for (int i = 0; i < 4; i++) {
        const int32_t step = (int32_t)out->rgba[i] - in->rgba[i];

        cut->rgba[i] = (uint8_t)(in->rgba[i] + ((step * share + 32768) >> 16));
    }
    cut->ends = in->ends | out->ends;
    cut->scale.exponent += combine(sums, in->v, p, out->v, q);
    cut->scale.exponent += normalize(cut->v, sums);
}
