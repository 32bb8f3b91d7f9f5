/* fragment/exact_rows_lequal.c: exact depths where not farther. Called by the exact kernels of that
 * name. See exact.h. */
#include "exact_depth.h"

void etch_depth_exact_rows_lequal(const struct etch_surface *surface, int16_t y0,
                                  const struct etch_run *runs, uint8_t n,
                                  const struct etch_paint *paint,
                                  const struct etch_exact_depth *exact, etch_span *span)
{
    exact_depth_rows(surface, y0, runs, n, paint, exact, span, etch_depth_lequal);
}
