/* fragment/depth_rows_lequal.c: depth first, where not farther. Called by the kernels whose names
 * end in lequal. See depth_rows.h. */
#include "depth_walk.h"

void etch_depth_rows_lequal(const struct etch_surface *surface, int16_t y0,
                            const struct etch_run *runs, uint8_t n, const struct etch_paint *paint,
                            etch_span *span)
{
    depth_rows(surface, y0, runs, n, paint, span, etch_depth_lequal);
}
