/* raster/ring.h: the rows of rings and arcs; no part of the API. */
#ifndef ETCH_RASTER_RING_H
#define ETCH_RASTER_RING_H

#include "disc_half.h"

struct etch_ring {
    int32_t cx, cy;
    struct etch_disc_view view;
    struct etch_disc_half outer, inner; /* inner.r = -1: no hole that may be seen */
};

/* The radii, as arc.h, of a ring with the rest set. False if nothing can be seen. */
bool etch_ring_init_radii(struct etch_ring *p, int32_t outer, int32_t inner);

/* `view` has the columns that matter. */
ETCH_INLINE bool etch_ring_init(struct etch_ring *p, int16_t cx, int16_t cy, int32_t outer,
                                int32_t inner, struct etch_span view)
{
    p->cx = cx;
    p->cy = cy;
    etch_disc_view_init(&p->view, cx, view.x0, view.x1);
    return etch_ring_init_radii(p, outer, inner);
}

/* The half widths of row y: what is at most w and more than the hole, -1 if it has none. */
struct etch_ring_row {
    int32_t w, hole;
};
struct etch_ring_row etch_ring_at(struct etch_ring *p, int32_t y);

ETCH_INLINE struct etch_rows etch_ring_rows(struct etch_ring *p, void *shape,
                                            etch_row_function *row)
{
    const struct etch_rows r = {row, shape, p->cy - p->outer.r, p->cy + p->outer.r};

    return r;
}

/* A row of the whole ring; shape: struct etch_ring. */
etch_row_function etch_ring_spans;

#endif
