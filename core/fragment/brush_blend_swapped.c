/* fragment/brush_blend_swapped.c: runs of a brush with opacity. Shapes call it through a paint. See
 * brush.h. */
#include "brush_blend_template.h"

void etch_kernel_brush_blend_swapped(const struct etch_surface *surface, int16_t y0,
                                     const struct etch_run *runs, uint8_t n,
                                     const struct etch_paint *paint)
{
    brush_runs(surface, y0, runs, n, paint, true);
}
