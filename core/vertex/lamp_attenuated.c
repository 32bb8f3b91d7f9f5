/* vertex/lamp_attenuated.c: lamps at a place whose light becomes less with distance. Called by the
 * shade functions. See lamp.h. */
#include "lamp_sum.h"

static uint64_t at_most_u32(uint64_t v)
{
    return v < UINT32_MAX ? v : UINT32_MAX;
}

static uint64_t not_below_0(etch_q16 v)
{
    return v > 0 ? (uint64_t)v : 0;
}

/* 1 / (constant + (linear + quadratic d) d), d below 2^32; the slope in 32 leading bits. */
static uint32_t attenuation_q16(const struct etch_lamp *lamp, uint64_t d_q16)
{
    uint64_t slope_q32 = (not_below_0(lamp->linear) << 16) + not_below_0(lamp->quadratic) * d_q16;
    uint64_t divisor = not_below_0(lamp->constant);
    uint8_t down = 32;

    for (; slope_q32 > UINT32_MAX; slope_q32 >>= 1)
        down--;
    divisor += slope_q32 * d_q16 >> down;
    if (divisor <= 1 << 14)
        return UINT32_C(1) << 18;
    return (uint32_t)etch_divide_u64((UINT64_C(1) << 32) + divisor / 2, divisor).quotient;
}

void etch_lamp_attenuated(const struct etch_lamp *lamp, const etch_q16 position[3],
                          struct etch_incidence *out)
{
    int32_t away[3];
    int64_t distance_q29 = 0;

    lamp_away(away, &lamp->place, position);
    (void)etch_unit_q14(out->towards, away);
    /* the distance is its own component in its direction; away has 15 fraction bits */
    for (int k = 0; k < 3; k++)
        distance_q29 += etch_mul_s32(away[k], out->towards[k]);
    out->intensity_q16 = attenuation_q16(
        lamp, at_most_u32((uint64_t)(distance_q29 > 0 ? distance_q29 : 0) >> 13));
}
