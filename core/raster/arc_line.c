/* raster/arc_line.c: parts of circles to runs. Called by draw/ and applications. See arc.h.
 *
 * The circle is the disc less what is inside its border: on row b the columns less than w(b) from
 * the centre, and no further than w(b + 1), the row beyond. */
#include "arc.h"
#include "arc_part.h"

static struct etch_ring_row circle_at(struct etch_ring *p, int32_t y)
{
    const int32_t b = y < p->cy ? p->cy - y : y - p->cy;
    const int32_t w = etch_disc_half_width(&p->outer, &p->view, b);
    const int32_t beyond = etch_disc_half_width(&p->inner, &p->view, b + 1);
    const struct etch_ring_row at = {w, beyond < w ? beyond : w - 1};

    return at;
}

static void spans(void *shape, int32_t y, struct etch_row *row)
{
    struct etch_arc_part *const p = shape;

    etch_sector_move(&p->sector, p->ring.cx, y - p->ring.cy);
    etch_arc_part_add(p, row, circle_at(&p->ring, y));
}

void etch_arc_line_runs(const struct etch_surface *s, int16_t cx, int16_t cy, int16_t r,
                        uint16_t from, uint32_t sweep, const struct etch_paint *paint)
{
    struct etch_arc_part p;

    if (etch_arc_part_init(&p, cx, cy, r, -1, from, sweep, etch_rows_seen(s), s->clip.y0)) {
        const struct etch_rows rows = etch_ring_rows(&p.ring, &p, spans);

        p.ring.inner = p.ring.outer;
        etch_rows_fill(s, &rows, paint);
    }
}
