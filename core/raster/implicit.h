/* raster/implicit.h: shapes given by a function: the pixels where F(x, y) < 0.
 *
 * F is the caller's, at integer pixels. Evaluating it everywhere is slow, so the shape also says
 * of a tile of pixels whether it is inside, outside or not known: tiles of 32 x 32 that are known
 * are filled or skipped in one piece, the others are quartered down to 4 x 4 and then asked pixel
 * by pixel. The answers only save time; as long as none is wrong, the pixels are exactly those
 * where F < 0, whatever the clip or strip. Source: T. Duff, "Interval arithmetic and recursive
 * subdivision for implicit functions and constructive solid geometry", 1992.
 *
 * Quadrics, without a function to call: quadric.h.
 */
#ifndef ETCH_RASTER_IMPLICIT_H
#define ETCH_RASTER_IMPLICIT_H

#include "../base/paint.h"

struct etch_implicit;

/* F at pixel (x, y), which is inside the box and the clip. */
typedef int32_t etch_implicit_value_function(const struct etch_implicit *shape, int16_t x,
                                             int16_t y);

enum etch_implicit_side {
    ETCH_IMPLICIT_OUTSIDE, /* F >= 0 at every pixel of the tile */
    ETCH_IMPLICIT_INSIDE,  /* F < 0 at every pixel of it */
    ETCH_IMPLICIT_UNKNOWN  /* always right */
};

/* What is known of a tile, which is not empty and within the box. */
typedef enum etch_implicit_side etch_implicit_side_function(const struct etch_implicit *shape,
                                                            struct etch_rect tile);

/* The head of every shape: the first member of a struct with its numbers. */
struct etch_implicit {
    etch_implicit_value_function *value;
    etch_implicit_side_function *side; /* the one below, or a caller's */
    uint32_t slope;                    /* read by etch_implicit_side_slope */
    struct etch_rect box;              /* pixels outside it are not drawn, and not asked */
};

/* A side function for shapes of which it is known how fast F changes: from a pixel to its neighbour
 * in x or in y by at most `slope`, all over the box. It asks the value in the middle of the tile.
 */
etch_implicit_side_function etch_implicit_side_slope;

/* The answer of a side function that knows bounds, least <= F <= most on the tile. */
ETCH_INLINE enum etch_implicit_side etch_implicit_side_bounds(int32_t least, int32_t most)
{
    return most < 0     ? ETCH_IMPLICIT_INSIDE
           : least >= 0 ? ETCH_IMPLICIT_OUTSIDE
                        : ETCH_IMPLICIT_UNKNOWN;
}

/* Hands the runs inside surface->clip to the paint, each pixel once, in rows of tiles from top to
 * bottom, each from left to right. A tile of which nothing is known keeps 64 words on the stack. */
void etch_implicit_runs(const struct etch_surface *surface, const struct etch_implicit *shape,
                        const struct etch_paint *paint);

#endif
