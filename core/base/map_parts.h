/* base/map_parts.h: what the makers of maps share; no part of the API. */
#ifndef ETCH_BASE_MAP_PARTS_H
#define ETCH_BASE_MAP_PARTS_H

#include "map.h"

/* A map that draws nothing. */
void etch_map_nothing(struct etch_map *map);

/* Bounds that hold the corners of `from`, carried over by `a` and moved by (x, y) instead of its
 * own, and two pixels more; 16.16. */
struct etch_rect etch_map_bounds(struct etch_rect from, const struct etch_affine *a, int64_t x,
                                 int64_t y);

/* step (x - 1/2) for |step| <= 2^45: below 2^60 + 2^45. */
ETCH_INLINE int64_t etch_map_along(int64_t step_q32, etch_q16 x)
{
    return step_q32 * (x >> 16) + ((step_q32 * (x & 0xFFFF)) >> 16) - step_q32 / 2;
}

#endif
