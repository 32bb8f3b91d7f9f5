/* base/trig.h: integer sine. Angles are 65536ths of a turn, so they wrap by themselves.
 *
 * Exact at quarter turns; in 2.30 also odd: sin(-a) = -sin(a), sin(1/2 - a) = sin(a). Nothing
 * is read from a table. Source: Taylor series on the quarter turn, in Horner's form.
 */
#ifndef ETCH_BASE_TRIG_H
#define ETCH_BASE_TRIG_H

#include "fixed.h"

/* sin(angle), -2^30 .. 2^30. Errs by less than 2 units of 2^-30 for each of the 65536 angles.
 * About 8 widening multiplications. */
int32_t etch_sin_q30(uint16_t angle);

/* cos(angle) in the same way. */
ETCH_INLINE int32_t etch_cos_q30(uint16_t angle)
{
    return etch_sin_q30((uint16_t)((uint32_t)angle + 0x4000));
}

/* sin(angle) in 16.16, -65536 .. 65536. Errs by at most 1/2 + 2^-13 units of 2^-16. */
ETCH_INLINE etch_q16 etch_sin_q16(uint16_t angle)
{
    return (etch_sin_q30(angle) + 8192) >> 14;
}

ETCH_INLINE etch_q16 etch_cos_q16(uint16_t angle)
{
    return (etch_cos_q30(angle) + 8192) >> 14;
}

#endif
