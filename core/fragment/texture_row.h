/* fragment/texture_row.h: the loops that the texture kernels are made of; no part of the API. */
#ifndef ETCH_FRAGMENT_TEXTURE_ROW_H
#define ETCH_FRAGMENT_TEXTURE_ROW_H

#include "template.h"
#include "texture.h"

/* Coordinates at a pixel and their steps to the next, in the formats of etch_texel_map. */
struct etch_texel_walk {
    uint32_t u, v, du, dv;
};

/* n pixels from `pixel` on, the first at walk->u, v. */
void etch_texel_row(uint16_t *pixel, uint32_t n, const struct etch_texel_walk *walk,
                    const struct etch_texel_map *map);

ETCH_INLINE uint16_t etch_texel_at(const struct etch_texel_map *map, uint32_t u, uint32_t v)
{
    return *(const uint16_t *)((uintptr_t)(u >> 19 & map->columns) + (uintptr_t)map->texels +
                               (uintptr_t)(v >> 15 & map->rows));
}

/* Writes depths while they pass, from `stored` on, which passes; returns the first that does not,
 * or end; *z follows. */
ETCH_INLINE uint16_t *etch_depth_write(uint16_t *stored, const uint16_t *end, uint32_t *z,
                                       uint32_t dz, etch_depth_test *passes)
{
    uint32_t depth = *z;

    for (;;) {
        *stored = (uint16_t)(depth >> 16);
        depth = etch_wrap_add(depth, dz);
        if (++stored == end || !passes((uint16_t)(depth >> 16), *stored))
            break;
    }
    *z = depth;
    return stored;
}

#endif
