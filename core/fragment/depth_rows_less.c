/* fragment/depth_rows_less.c: depth first, where nearer. Called by the kernels whose names end in
 * less. See depth_rows.h. */
#include "depth_walk.h"

void etch_depth_rows_less(const struct etch_surface *surface, int16_t y0,
                          const struct etch_run *runs, uint8_t n, const struct etch_paint *paint,
                          etch_span *span)
{
    depth_rows(surface, y0, runs, n, paint, span, etch_depth_less);
}
