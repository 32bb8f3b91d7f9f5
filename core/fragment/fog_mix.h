/* fragment/fog_mix.h: what the fog stages share; no part of the API. */
#ifndef ETCH_FRAGMENT_FOG_MIX_H
#define ETCH_FRAGMENT_FOG_MIX_H

#include "fog.h"

/* 8-bit channels in the formats of a chunk, to nearest: 31 2^11 / 255 and 63 2^10 / 255. */
ETCH_INLINE void etch_fog_color(uint16_t color[3], uint8_t r, uint8_t g, uint8_t b)
{
    color[0] = (uint16_t)((r * UINT32_C(63488) + 127) / 255);
    color[1] = (uint16_t)((g * UINT32_C(64512) + 127) / 255);
    color[2] = (uint16_t)((b * UINT32_C(63488) + 127) / 255);
}

/* f in 1.15, 0 .. 2^15: both products together are below 2^31. */
ETCH_INLINE uint16_t etch_fog_channel(uint16_t color, uint16_t fog, uint32_t f)
{
    return (uint16_t)((color * f + fog * (32768 - f) + 16384) >> 15);
}

ETCH_INLINE void etch_fog_mix(struct etch_chunk *c, uint16_t i, const uint16_t color[3], uint32_t f)
{
    c->r[i] = etch_fog_channel(c->r[i], color[0], f);
    c->g[i] = etch_fog_channel(c->g[i], color[1], f);
    c->b[i] = etch_fog_channel(c->b[i], color[2], f);
}

#endif
