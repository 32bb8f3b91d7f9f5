/* fragment/blend_channel.h: the exact arithmetic of blending; no part of the API.
 *
 * A channel of a chunk is S = s 2^-bits steps, bits = 11 (red, blue) or 10 (green); alpha A 8.8.
 */
#ifndef ETCH_FRAGMENT_BLEND_CHANNEL_H
#define ETCH_FRAGMENT_BLEND_CHANNEL_H

#include "stage.h"

#define ETCH_BLEND_ONE UINT32_C(65280) /* 255 in 8.8 */

/* round((s A + d 2^bits (65280 - A)) / (65280 2^bits)), ties upwards, for s <= 63488 (64512 if bits
 * is 10): the numerator with its half is at most 64512 65280 + 2^9 65280 < 2^32. Of the divisor 255
 * 2^(8 + bits) the power of two goes first, which leaves m < 2^14; m / 255 is m 32897 2^-23. */
ETCH_INLINE uint32_t etch_blend_mix(uint32_t s, uint32_t d, uint32_t a, uint8_t bits)
{
    const uint32_t n = s * a + (d << bits) * (ETCH_BLEND_ONE - a) + (ETCH_BLEND_ONE << (bits - 1));

    return (n >> (8 + bits)) * 32897 >> 23;
}

/* round(s A / 65280 + d), ties upwards, before it is held to the range. */
ETCH_INLINE uint32_t etch_blend_sum(uint32_t s, uint32_t d, uint32_t a, uint8_t bits)
{
    const uint32_t n = s * a + (ETCH_BLEND_ONE << (bits - 1));

    return d + ((n >> (8 + bits)) * 32897 >> 23);
}

/* round(s d / (most 2^bits)), ties upwards; most = 31 or 63. m / (2^k - 1) is (m + 1 + m / 2^k) /
 * 2^k as long as m < 2^k (2^k - 1), which holds: m <= most^2 + most / 2 + 1. */
ETCH_INLINE uint32_t etch_blend_product(uint32_t s, uint32_t d, uint8_t bits, uint8_t k)
{
    const uint32_t most = (UINT32_C(1) << k) - 1;
    const uint32_t m = (s * d + (most << (bits - 1))) >> bits;

    return (m + 1 + (m >> k)) >> k;
}

ETCH_INLINE uint32_t etch_blend_least(uint32_t a, uint32_t b)
{
    return a < b ? a : b;
}

ETCH_INLINE uint32_t etch_pixel_red(uint16_t pixel)
{
    return (uint32_t)pixel >> 11;
}

ETCH_INLINE uint32_t etch_pixel_green(uint16_t pixel)
{
    return (uint32_t)pixel >> 5 & 63;
}

ETCH_INLINE uint32_t etch_pixel_blue(uint16_t pixel)
{
    return (uint32_t)pixel & 31;
}

#endif
