/* fragment/texture_row.h: the loops that the texture kernels are made of; no part of the API. */
#ifndef ETCH_FRAGMENT_TEXTURE_ROW_H
#define ETCH_FRAGMENT_TEXTURE_ROW_H

#include "depth_rows.h"
#include "texture.h"

/* Coordinates at a pixel and their steps to the next, in the formats of etch_texel_map. */
struct etch_texel_walk {
    uint32_t u, v, du, dv;
};

/* n pixels from `pixel` on, the first at walk->u, v. */
void etch_texel_row(uint16_t *pixel, uint32_t n, const struct etch_texel_walk *walk,
                    const struct etch_texel_map *map);

/* A span of affine texture; the paint is a struct etch_texture_paint. */
etch_span etch_texel_span;

ETCH_INLINE uint16_t etch_texel_at(const struct etch_texel_map *map, uint32_t u, uint32_t v)
{
    return *(const uint16_t *)((uintptr_t)(u >> 19 & map->columns) + (uintptr_t)map->texels +
                               (uintptr_t)(v >> 15 & map->rows));
}

#endif
