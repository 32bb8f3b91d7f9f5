/* vertex/reciprocal.h: the first guess of project.c's reciprocal; no part of the API. */
#ifndef ETCH_VERTEX_RECIPROCAL_H
#define ETCH_VERTEX_RECIPROCAL_H

#include "../base/fixed.h"

/* floor((2^32 - 1) / d) for d = 2^15 + 1 .. 2^16. The same on every core, in two forms. This one
 * divides. */
ETCH_INLINE uint32_t etch_reciprocal_by_division(uint32_t d)
{
    return UINT32_MAX / d;
}

/* This one makes five products, 30 instructions on ARMv6-M where a division is 100 or more. A line
 * through 48/17 - 32/17 d is at most 1/17 off; each of two steps of Newton's iteration,
 * r + r (1 - r d / 2^32), squares that, and r is then 0 .. 2 too small, which its remainder says.
 * |error| < 2^28 and r < 2^17, so both factors are below 2^15. */
ETCH_INLINE uint32_t etch_reciprocal_by_iteration(uint32_t d)
{
    uint32_t r = 185043 - (d * 61681 >> 15);

    for (uint8_t i = 0; i < 2; i++) {
        const int32_t error = (int32_t)etch_wrap_sub(0, etch_wrap_mul(r, d)); /* 2^32 - r d */

        r = (uint32_t)((int32_t)r + ((error >> 14) * (int32_t)(r >> 2) >> 16));
    }
    uint32_t rest = etch_wrap_sub(UINT32_MAX, etch_wrap_mul(r, d));

    for (; rest >= d; rest -= d)
        r++;
    return r;
}

#if defined(__ARM_ARCH_6M__) || defined(__AVR__) /* no divide */
ETCH_INLINE uint32_t etch_reciprocal(uint32_t d)
{
    return etch_reciprocal_by_iteration(d);
}
#else
ETCH_INLINE uint32_t etch_reciprocal(uint32_t d)
{
    return etch_reciprocal_by_division(d);
}
#endif

#endif
