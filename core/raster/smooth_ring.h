/* raster/smooth_ring.h: the lines of smooth rings; no part of the API. */
#ifndef ETCH_RASTER_SMOOTH_RING_H
#define ETCH_RASTER_SMOOTH_RING_H

#include "smooth_lines.h"

struct etch_smooth_ring {
    struct etch_point_q8 centre;
    int32_t outer, inner; /* inner < outer; below 0: no hole */
};

/* The two intervals of a line, left x0 .. x1 and right x2 .. x3; without a hole x1 = x2. False
 * without any. */
struct etch_ring_line {
    int32_t x0, x1, x2, x3;
};
ETCH_INLINE bool etch_smooth_ring_line(const struct etch_smooth_ring *p, int32_t y,
                                       struct etch_ring_line *at)
{
    const int32_t x = p->centre.x, dy = y - p->centre.y;
    const int32_t w = etch_smooth_half(p->outer, dy);
    const int32_t hole = w < 0 || p->inner <= 0 ? 0 : etch_smooth_half(p->inner, dy);

    at->x0 = x - w;
    at->x1 = hole > 0 ? x - hole : x;
    at->x2 = hole > 0 ? x + hole : x;
    at->x3 = x + w;
    return w >= 0;
}

ETCH_INLINE struct etch_smooth_lines etch_smooth_ring_lines(const struct etch_smooth_ring *p,
                                                            void *shape, etch_row_function *line)
{
    const struct etch_smooth_lines l = {line, shape, p->centre.y - p->outer,
                                        p->centre.y + p->outer};

    return l;
}

#endif
