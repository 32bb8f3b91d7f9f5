/* raster/ring.h: the rows of rings and arcs; no part of the API. */
#ifndef ETCH_RASTER_RING_H
#define ETCH_RASTER_RING_H

#include "oval.h"

struct etch_ring {
    int32_t cx, cy;
    struct etch_oval outer, inner;
    bool has_hole; /* the inner disc may be seen */
};

/* False if nothing can be seen: radii as arc.h. `view` as for ovals. */
bool etch_ring_init(struct etch_ring *p, int16_t cx, int16_t cy, int32_t outer, int32_t inner,
                    struct etch_span view);

/* The half widths of row y: what is at most w and more than the hole, -1 if it has none. */
struct etch_ring_row {
    int32_t w, hole;
};
struct etch_ring_row etch_ring_at(struct etch_ring *p, int32_t y);

ETCH_INLINE struct etch_rows etch_ring_rows(struct etch_ring *p, void *shape,
                                            etch_row_function *row)
{
    const struct etch_rows r = {row, shape, p->cy - p->outer.ry, p->cy + p->outer.ry};

    return r;
}

/* A row of the whole ring; shape: struct etch_ring. */
etch_row_function etch_ring_spans;

#endif
