/* raster/arc_outline.c: the borders of parts of rings to runs. Called by draw/ and applications.
 * See arc.h. */
#include "arc.h"
#include "arc_part.h"

void etch_arc_outline_runs(const struct etch_surface *s, int16_t cx, int16_t cy, int16_t outer,
                           int16_t inner, uint16_t from, uint32_t sweep,
                           const struct etch_paint *paint)
{
    struct etch_arc_part p;

    if (etch_arc_part_init(&p, cx, cy, outer, inner, from, sweep, etch_rows_known(s),
                           s->clip.y0 - 1)) {
        const struct etch_rows rows = etch_ring_rows(&p.ring, &p, etch_arc_spans);

        etch_rows_outline(s, &rows, paint);
    }
}
