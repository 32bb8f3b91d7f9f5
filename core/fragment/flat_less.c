/* fragment/flat_less.c: one colour where nearer than the depth plane. See flat.h. */
#include "flat_span.h"

void etch_kernel_flat_less(const struct etch_surface *surface, int16_t y0,
                           const struct etch_run *runs, uint8_t n, const struct etch_paint *paint)
{
    etch_depth_rows_less(surface, y0, runs, n, paint, flat_span);
}
