/* leaf/vector128/gouraud_planes.h: depth and colour of a row as the lanes of one vector; no part of
 * the API. */
#ifndef ETCH_LEAF_GOURAUD_PLANES_H
#define ETCH_LEAF_GOURAUD_PLANES_H

#include "../../fragment/gouraud.h"
#include "vector.h"

/* Lanes z, r, g, b: in column 0 of a row, and their steps. */
struct gouraud_planes {
    vector_u32 left, dx, dy;
};

typedef vector_u32 __attribute__((aligned(4), may_alias)) vector_words;

/* The four planes are twelve words, origin dx dy each: three loads, and of each three words the
 * first, the second, the third. */
ETCH_INLINE struct gouraud_planes gouraud_planes(const struct etch_gouraud_paint *p, int16_t y0)
{
    const vector_words *const words = (const vector_words *)(const void *)&p->z;
    const vector_u32 a = words[0], b = words[1], c = words[2];
    const vector_u32 gb = __builtin_shufflevector(b, c, 2, 2, 5, 5);
    const vector_u32 zr_dx = __builtin_shufflevector(a, b, 1, 1, 4, 4);
    const vector_u32 gb_dx = __builtin_shufflevector(b, c, 3, 3, 6, 6);
    const vector_u32 zr_dy = __builtin_shufflevector(a, b, 2, 2, 5, 5);
    struct gouraud_planes planes;

    planes.dx = __builtin_shufflevector(zr_dx, gb_dx, 0, 2, 4, 6);
    planes.dy = __builtin_shufflevector(zr_dy, c, 0, 2, 4, 7);
    planes.left = __builtin_shufflevector(a, gb, 0, 3, 4, 6) +
                  planes.dy * vector_all((uint32_t)(int32_t)y0);
    return planes;
}

/* In column x of the row. */
ETCH_INLINE vector_u32 gouraud_planes_at(const struct gouraud_planes *p, uint32_t x)
{
    return p->left + p->dx * vector_all(x);
}

#endif
