/* raster/arc_part.h: the rows of a part of a ring; no part of the API. */
#ifndef ETCH_RASTER_ARC_PART_H
#define ETCH_RASTER_ARC_PART_H

#include "ring.h"
#include "sector.h"

struct etch_arc_part {
    struct etch_ring ring;
    struct etch_sector sector;
};

/* For the rows from `first` on. False if nothing can be seen. */
ETCH_INLINE bool etch_arc_part_init(struct etch_arc_part *p, int16_t cx, int16_t cy, int32_t outer,
                                    int32_t inner, uint16_t from, uint32_t sweep,
                                    struct etch_span view, int32_t first)
{
    if (sweep == 0 || !etch_ring_init(&p->ring, cx, cy, outer, inner, view))
        return false;
    etch_sector_init(&p->sector, from, sweep, (first > cy - outer ? first : cy - outer) - cy, 1);
    return true;
}

/* Adds what of the row is in the sector, which stands on it. */
void etch_arc_part_add(const struct etch_arc_part *p, struct etch_row *row,
                       struct etch_ring_row at);

/* A row of the part; shape: struct etch_arc_part. */
etch_row_function etch_arc_spans;

#endif
