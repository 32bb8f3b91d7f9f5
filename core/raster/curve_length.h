/* raster/curve_length.h: what the two kinds of curves share; no part of the API. */
#ifndef ETCH_RASTER_CURVE_LENGTH_H
#define ETCH_RASTER_CURVE_LENGTH_H

#include "curve.h"

/* At least the length of a - 2 b + c, and at most 1.12 times it, plus one: most + least / 2, whose
 * square most^2 + most least + least^2 / 4 >= most^2 + least^2. Below 2^26. */
ETCH_INLINE uint32_t second_difference(struct etch_point_q8 a, struct etch_point_q8 b,
                                       struct etch_point_q8 c)
{
    const int32_t x = a.x - 2 * b.x + c.x, y = a.y - 2 * b.y + c.y;
    const uint32_t dx = (uint32_t)(x < 0 ? -x : x), dy = (uint32_t)(y < 0 ? -y : y);

    return dx > dy ? dx + (dy + 1) / 2 : dy + (dx + 1) / 2;
}

/* v 2^-bits, rounded half up. */
ETCH_INLINE int32_t curve_round(int64_t v, uint8_t bits)
{
    return bits == 0 ? (int32_t)v : (int32_t)((v + (INT64_C(1) << (bits - 1))) >> bits);
}

#endif
