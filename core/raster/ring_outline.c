/* raster/ring_outline.c: the borders of rings to runs. Called by draw/ and applications. See arc.h.
 */
#include "arc.h"
#include "ring.h"

void etch_ring_outline_runs(const struct etch_surface *s, int16_t cx, int16_t cy, int16_t outer,
                            int16_t inner, const struct etch_paint *paint)
{
    struct etch_ring p;

    if (etch_ring_init(&p, cx, cy, outer, inner, etch_rows_known(s))) {
        const struct etch_rows rows = etch_ring_rows(&p, &p, etch_ring_spans);

        etch_rows_outline(s, &rows, paint);
    }
}
