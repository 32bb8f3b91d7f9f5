/* leaf/vector128/depth_rows_less.c: etch_depth_rows_less by vectors, in place of
 * fragment/depth_rows_less.c. Called by the kernels whose names end in less. */
#include "depth_rows.h"

void etch_depth_rows_less(const struct etch_surface *surface, int16_t y0,
                          const struct etch_run *runs, uint8_t n, const struct etch_paint *paint,
                          etch_span *span)
{
    depth_rows(surface, y0, runs, n, paint, span, depth_lanes_less, etch_depth_less);
}
