/* raster/arc_part.h: the rows of a part of a ring; no part of the API. */
#ifndef ETCH_RASTER_ARC_PART_H
#define ETCH_RASTER_ARC_PART_H

#include "ring.h"
#include "sector.h"

struct etch_arc_part {
    struct etch_ring ring;
    struct etch_sector sector;
};

/* False if nothing can be seen. */
ETCH_INLINE bool etch_arc_part_init(struct etch_arc_part *p, int16_t cx, int16_t cy, int32_t outer,
                                    int32_t inner, uint16_t from, uint32_t sweep,
                                    struct etch_span view)
{
    if (sweep == 0 || !etch_ring_init(&p->ring, cx, cy, outer, inner, view))
        return false;
    etch_sector_init(&p->sector, from, sweep, 1);
    return true;
}

/* What of the ring's row is in the sector. */
ETCH_INLINE void etch_arc_part_add(struct etch_arc_part *p, struct etch_row *row, int32_t y,
                                   struct etch_ring_row at)
{
    const int32_t cx = p->ring.cx, b = y - p->ring.cy;

    if (at.hole < 0) {
        etch_sector_add(&p->sector, row, cx, b, cx - at.w, cx + at.w + 1);
        return;
    }
    etch_sector_add(&p->sector, row, cx, b, cx - at.w, cx - at.hole);
    etch_sector_add(&p->sector, row, cx, b, cx + at.hole + 1, cx + at.w + 1);
}

/* A row of the part; shape: struct etch_arc_part. */
etch_row_function etch_arc_spans;

#endif
