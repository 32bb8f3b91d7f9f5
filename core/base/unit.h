/* base/unit.h: vectors of length one, by an integer reciprocal square root. */
#ifndef ETCH_BASE_UNIT_H
#define ETCH_BASE_UNIT_H

#include "fixed.h"

/* 2^31 / sqrt(s) for s = 2^30 .. 2^32 - 1, that is 2^16 .. 2^15; is at most 2.42
 * units too small and 0.93 too large (all 3 2^30 tried). Newton's
 * iteration from the best straight line, without a division: 64 instructions, 80 cycles on
 * Cortex-M0+. */
uint32_t etch_rsqrt_q31(uint32_t s);

/* unit = v / |v| in 2.14, each component within 2 units, |unit| within 2 units of 2^14. False, and
 * unit all zero, for the zero vector. Every input is legal. About 220 instructions, 285 cycles on
 * Cortex-M0+. */
bool etch_unit_q14(int16_t unit[3], const int32_t v[3]);

/* a . b of vectors in 2.14, in 4.28: exact, below 2^30 for lengths up to 1.1. */
ETCH_INLINE int32_t etch_dot_q28(const int16_t a[3], const int16_t b[3])
{
    return etch_mul_s16(a[0], b[0]) + etch_mul_s16(a[1], b[1]) + etch_mul_s16(a[2], b[2]);
}

#endif
