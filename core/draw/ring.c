/* draw/ring.c: rings in one colour. Called by applications. See round.h. */
#include "../fragment/flat.h"
#include "../raster/arc.h"
#include "round.h"

void etch_ring_fill(const struct etch_surface *s, int16_t cx, int16_t cy, int16_t outer,
                    int16_t inner, uint16_t color)
{
    const struct etch_flat_paint paint = {{etch_kernel_flat}, color};

    etch_ring_runs(s, cx, cy, outer, inner, &paint.paint);
}

void etch_ring_draw(const struct etch_surface *s, int16_t cx, int16_t cy, int16_t outer,
                    int16_t inner, uint16_t color)
{
    const struct etch_flat_paint paint = {{etch_kernel_flat}, color};

    etch_ring_outline_runs(s, cx, cy, outer, inner, &paint.paint);
}
