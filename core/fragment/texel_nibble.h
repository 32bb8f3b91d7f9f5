/* fragment/texel_nibble.h: where a 4-bit texel stands; no part of the API. */
#ifndef ETCH_FRAGMENT_TEXEL_NIBBLE_H
#define ETCH_FRAGMENT_TEXEL_NIBBLE_H

#include "sampler.h"

ETCH_INLINE uint8_t etch_texel_nibble(const uint8_t *texels, uint32_t place)
{
    const uint8_t pair = texels[place >> 1];

    return (uint8_t)((place & 1) != 0 ? pair >> 4 : pair & 15);
}

#endif
