/* raster/arc.c: parts of rings to runs. Called by draw/ and applications. See arc.h. */
#include "arc.h"
#include "arc_part.h"

ETCH_APART void etch_arc_part_add(const struct etch_arc_part *p, struct etch_row *row,
                                  struct etch_ring_row at)
{
    const int32_t cx = p->ring.cx;

    if (at.hole < 0) {
        etch_sector_add(&p->sector, row, cx - at.w, cx + at.w + 1);
        return;
    }
    etch_sector_add(&p->sector, row, cx - at.w, cx - at.hole);
    etch_sector_add(&p->sector, row, cx + at.hole + 1, cx + at.w + 1);
}

void etch_arc_spans(void *shape, int32_t y, struct etch_row *row)
{
    struct etch_arc_part *const p = shape;

    etch_sector_move(&p->sector, p->ring.cx, y - p->ring.cy);
    etch_arc_part_add(p, row, etch_ring_at(&p->ring, y));
}

void etch_arc_runs(const struct etch_surface *s, int16_t cx, int16_t cy, int16_t outer,
                   int16_t inner, uint16_t from, uint32_t sweep, const struct etch_paint *paint)
{
    struct etch_arc_part p;

    if (etch_arc_part_init(&p, cx, cy, outer, inner, from, sweep, etch_rows_seen(s), s->clip.y0)) {
        const struct etch_rows rows = etch_ring_rows(&p.ring, &p, etch_arc_spans);

        etch_rows_fill(s, &rows, paint);
    }
}
