/* fragment/texel_place.h: what the wraps of sampler.h share; no part of the API. */
#ifndef ETCH_FRAGMENT_TEXEL_PLACE_H
#define ETCH_FRAGMENT_TEXEL_PLACE_H

#include "sampler.h"

/* floor(c + shift), -32769 .. 32768. Half the coordinate leaves room for the shift, and the bit that
 * it drops is below that of the shift. */
ETCH_INLINE int32_t etch_texel_floor(int32_t c_q16, int16_t shift_q15)
{
    return ((c_q16 >> 1) + shift_q15) >> 15;
}

/* The greatest multiple of `period` that is not above k; |k| <= 32769, 1 <= period <= 65534. */
ETCH_INLINE int32_t etch_texel_period(int32_t k, int32_t period)
{
    const int32_t multiple = k / period * period;

    return multiple > k ? multiple - period : multiple;
}

#endif
