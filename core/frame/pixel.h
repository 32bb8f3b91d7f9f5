/* frame/pixel.h: sums and averages of RGB565 pixels, what the passes share; no part of the API. */
#ifndef ETCH_FRAME_PIXEL_H
#define ETCH_FRAME_PIXEL_H

#include "../base/rgb565.h"
#include "../base/surface.h"

/* The three channels of a pixel in one word, 00000gggggg00000rrrrr000000bbbbb: up to 32 of them
 * add without a carry from one channel into the next (32 * 31 < 2^10, 32 * 63 < 2^11). */
#define PIXEL_MASK UINT32_C(0x07E0F81F)

/* One step in each channel. */
#define PIXEL_ONES UINT32_C(0x00200801)

ETCH_INLINE uint32_t pixel_spread(uint16_t color)
{
    return ((uint32_t)color << 16 | color) & PIXEL_MASK;
}

ETCH_INLINE uint16_t pixel_join(uint32_t spread)
{
    return (uint16_t)((spread >> 16 | spread) & 0xFFFF);
}

/* The sums in a word of spread pixels. */
ETCH_INLINE uint32_t pixel_red(uint32_t sum)
{
    return sum >> 11 & 0x3FF;
}
ETCH_INLINE uint32_t pixel_green(uint32_t sum)
{
    return sum >> 21;
}
ETCH_INLINE uint32_t pixel_blue(uint32_t sum)
{
    return sum & 0x7FF;
}

ETCH_INLINE uint16_t pixel_pack(uint32_t r, uint32_t g, uint32_t b)
{
    return (uint16_t)(r << 11 | g << 5 | b);
}

/* In the order of the surface that it is written to. */
ETCH_INLINE uint16_t pixel_ordered(uint16_t color, const bool swapped)
{
    return swapped ? etch_rgb565_swap(color) : color;
}

/* ---- division by a number that is the same for all pixels, 1 .. 65535 ---------------------- */

struct pixel_divisor {
    uint32_t d, reciprocal; /* floor(2^22 / d) */
};

ETCH_INLINE struct pixel_divisor pixel_divisor(uint16_t d)
{
    const struct pixel_divisor v = {d, (UINT32_C(1) << 22) / d};

    return v;
}

/* floor(n / d), held to 0 .. most, for most <= 63. Below 64 d the product is below 2^28, and the
 * reciprocal's error makes the quotient at most n / 2^22 < 1 too small. */
ETCH_INLINE uint32_t pixel_divide(int32_t n, struct pixel_divisor v, uint32_t most)
{
    if (n <= 0)
        return 0;
    if ((uint32_t)n >= (most + 1) * v.d)
        return most;

    const uint32_t q = (uint32_t)n * v.reciprocal >> 22;

    return (uint32_t)n - q * v.d >= v.d ? q + 1 : q;
}

#endif
