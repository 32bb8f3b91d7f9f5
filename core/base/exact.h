/* base/exact.h: interpolated values as whole numbers, for the few pixels where rounding is close.
 *
 * A varying that is value[i] at the vertices of a triangle of twice the area D is, at a pixel of
 * it, N / D with
 *
 *      N(x, y) = sum value[i] e_i(x, y) = origin + x dx + y dy,    e_i the edge functions
 *
 * all integers. The exact modes step a plane of 32 bits (paint.h), which is within a known distance
 * of N / D. Where that distance decides nothing, it decides; where a step of the output is nearer
 * than that, N says on which side of it the value lies. Only differences of less than 2^63 count
 * there, so N is kept modulo 2^64, whatever it may be: no wider number, and no division.
 */
#ifndef ETCH_BASE_EXACT_H
#define ETCH_BASE_EXACT_H

#include "fixed.h"

/* N modulo 2^64. */
struct etch_exact_plane {
    uint64_t origin, dx, dy;
};

ETCH_INLINE uint64_t etch_wrap_add_u64(uint64_t a, uint64_t b)
{
    return a + b;
}

ETCH_INLINE uint64_t etch_wrap_sub_u64(uint64_t a, uint64_t b)
{
    return a - b;
}

ETCH_INLINE uint64_t etch_wrap_mul_u64(uint64_t a, uint64_t b)
{
    return a * b;
}

/* N - level at pixel (x, y) of the frame, where that is above -2^63 and below 2^63; level is modulo
 * 2^64 too. */
ETCH_INLINE int64_t etch_exact_above(const struct etch_exact_plane *p, int16_t x, int16_t y,
                                     uint64_t level)
{
    const uint64_t across = etch_wrap_mul_u64(p->dx, (uint16_t)x);
    const uint64_t down = etch_wrap_mul_u64(p->dy, (uint16_t)y);
    const uint64_t n = etch_wrap_add_u64(p->origin, etch_wrap_add_u64(across, down));

    return (int64_t)etch_wrap_sub_u64(n, level);
}

#endif
