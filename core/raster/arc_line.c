/* raster/arc_line.c: parts of circles to runs. Called by draw/ and applications. See arc.h.
 *
 * The circle is the disc less what is inside its border: on row b the columns less than w(b) from the centre,
 * and no further than w(b + 1), the row beyond. */
#include "arc.h"
#include "arc_part.h"

static void spans(void *shape, int32_t y, struct etch_row *row)
{
    struct etch_arc_part *const p = shape;
    const int32_t b = y < p->ring.cy ? p->ring.cy - y : y - p->ring.cy;
    const int32_t w = etch_oval_width(&p->ring.outer, b);
    const int32_t beyond = etch_oval_width(&p->ring.inner, b + 1);
    const struct etch_ring_row at = {w, beyond < w ? beyond : w - 1};

    etch_arc_part_add(p, row, y, at);
}

void etch_arc_line_runs(const struct etch_surface *s, int16_t cx, int16_t cy, int16_t r,
                        uint16_t from, uint32_t sweep, const struct etch_paint *paint)
{
    struct etch_arc_part p;

    if (etch_arc_part_init(&p, cx, cy, r, -1, from, sweep, etch_rows_seen(s))) {
        const struct etch_rows rows = etch_ring_rows(&p.ring, &p, spans);

        p.ring.inner = p.ring.outer;
        etch_rows_fill(s, &rows, paint);
    }
}
