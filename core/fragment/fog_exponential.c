/* fragment/fog_exponential.c: fog that grows exponentially with depth. A stage; see fog.h.
 *
 *      exp(-density z / 65535) = 2^-t,   t = z rate / 2^32,   rate = density log2(e) 2^32 / 65535
 *
 * z < 2^16, so rate needs as many bits as t has before the point and 16 more; beyond t = 16 nothing
 * of f is left.
 */
#include "fog_mix.h"

/* log2(e) 65536 / 65535 2^30, to nearest */
#define LOG2E_Q30 UINT32_C(1549105642)

enum etch_status etch_fog_exponential_init(struct etch_fog_exponential *fog, etch_q16 density,
                                           uint8_t r, uint8_t g, uint8_t b)
{
    if (density < 0)
        return ETCH_EINVAL;
    /* 2^(32 - 16 - 16 + 30): density q16, 2^30 of the constant, one 2^16 in it; below
       2^31 * 1.4427, which fits */
    etch_fog_color(fog->color, r, g, b);
    fog->rate = (uint32_t)((uint64_t)etch_mul_s32(density, (int32_t)LOG2E_Q30) >> 30);
    return ETCH_OK;
}

/* 2^-x in 1.15 for x = 0 .. 65535 / 65536: 1 - ln2 x + (ln2 x)^2 / 2 - .., its coefficients moved
 * to spread the error, which is below 2^-18; each product drops less than 2^-16. */
static uint32_t power(uint32_t x)
{
    uint32_t p = 452;

    p = 3496 - (p * x >> 16);
    p = 15698 - (p * x >> 16);
    p = 45421 - (p * x >> 16);
    return (131072 - (p * x >> 15) + 2) >> 2;
}

void etch_stage_fog_exponential(struct etch_chunk *c, const void *data)
{
    const struct etch_fog_exponential *const fog = (const struct etch_fog_exponential *)data;
    const uint32_t high = fog->rate >> 16, low = fog->rate & 0xFFFF;

    for (uint16_t i = 0; i < c->n; i++) {
        const uint32_t z = c->z[i];
        const uint32_t t = z * high + (z * low >> 16); /* 16.16; high z < 2^32 - 2^17 */

        etch_fog_mix(c, i, fog->color, t >> 16 < 16 ? power(t & 0xFFFF) >> (t >> 16) : 0);
    }
}
