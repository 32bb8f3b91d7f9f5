/* fragment/texture_factor.h: channels as factors 0 .. 1; no part of the API.
 *
 * A channel that is full at m is v / m of full. v 2^16 / m = v + v (2^16 - m) / m, whose second
 * term is a product with its factor in 2^-20, rounded up: less than one unit below, 1/16 above. */
#ifndef ETCH_FRAGMENT_TEXTURE_FACTOR_H
#define ETCH_FRAGMENT_TEXTURE_FACTOR_H

#include "../base/fixed.h"

/* 5.11 to 0 .. 65536; 33826 = 2^20 / 31, 63488 x 33826 < 2^32. */
ETCH_INLINE uint32_t etch_factor_q11(uint16_t v)
{
    return v + (v * UINT32_C(33826) >> 20);
}

/* 6.10 to 0 .. 65536; 16645 = 2^20 / 63. */
ETCH_INLINE uint32_t etch_factor_q10(uint16_t v)
{
    return v + (v * UINT32_C(16645) >> 20);
}

/* 8.8 to 0 .. 65536; 4113 = 2^20 / 255. */
ETCH_INLINE uint32_t etch_factor_q8(uint16_t v)
{
    return v + (v * UINT32_C(4113) >> 20);
}

#endif
