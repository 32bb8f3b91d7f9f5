/* draw/pie.c: pies in one colour. Called by applications. See round.h. */
#include "../fragment/flat.h"
#include "../raster/arc.h"
#include "round.h"

void etch_pie_fill(const struct etch_surface *s, int16_t cx, int16_t cy, int16_t r, uint16_t from,
                   uint32_t sweep, uint16_t color)
{
    const struct etch_flat_paint paint = {{etch_kernel_flat}, color};

    etch_arc_runs(s, cx, cy, r, -1, from, sweep, &paint.paint);
}

void etch_pie_draw(const struct etch_surface *s, int16_t cx, int16_t cy, int16_t r, uint16_t from,
                   uint32_t sweep, uint16_t color)
{
    const struct etch_flat_paint paint = {{etch_kernel_flat}, color};

    etch_arc_outline_runs(s, cx, cy, r, -1, from, sweep, &paint.paint);
}
