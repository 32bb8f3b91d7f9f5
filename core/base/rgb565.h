/* base/rgb565.h: the pixel format, rrrrrggggggbbbbb, and its byte-swapped form for panels
 * that take the high byte first from memory. A colour given to a drawing call is in the
 * surface's order: swap it once, not per pixel. */
#ifndef ETCH_BASE_RGB565_H
#define ETCH_BASE_RGB565_H

#include "fixed.h"

/* Nearest RGB565 to 8-bit channels: round(v * 31 / 255) and round(v * 63 / 255). There are
 * no ties. (v * 249 + 1014) >> 11 and (v * 253 + 505) >> 10 equal both for all 256 values. */
ETCH_INLINE uint16_t etch_rgb565(uint8_t r, uint8_t g, uint8_t b)
{
    const uint32_t r5 = (r * UINT32_C(249) + 1014) >> 11;
    const uint32_t g6 = (g * UINT32_C(253) + 505) >> 10;
    const uint32_t b5 = (b * UINT32_C(249) + 1014) >> 11;
    return (uint16_t)(r5 << 11 | g6 << 5 | b5);
}

/* The two bytes exchanged: rgb565 <-> rgb565_swapped. */
ETCH_INLINE uint16_t etch_rgb565_swap(uint16_t color)
{
    return (uint16_t)((uint32_t)color << 8 | (uint32_t)color >> 8);
}

/* 8-bit channels by bit replication, as picture files store them. */
ETCH_INLINE uint8_t etch_rgb565_red(uint16_t color)
{
    return (uint8_t)((color >> 8 & 0xF8) | color >> 13);
}

ETCH_INLINE uint8_t etch_rgb565_green(uint16_t color)
{
    return (uint8_t)((color >> 3 & 0xFC) | (color >> 9 & 3));
}

ETCH_INLINE uint8_t etch_rgb565_blue(uint16_t color)
{
    return (uint8_t)((color << 3 & 0xF8) | (color >> 2 & 7));
}

#endif
