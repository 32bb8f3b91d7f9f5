/* fragment/flat_exact_lequal.c: one colour where not farther, depths correctly rounded. See
 * exact.h. */
#include "exact.h"
#include "flat_span.h"

void etch_kernel_flat_exact_lequal(const struct etch_surface *surface, int16_t y0,
                                   const struct etch_run *runs, uint8_t n,
                                   const struct etch_paint *paint)
{
    etch_depth_exact_rows_lequal(surface, y0, runs, n, paint,
                                 &((const struct etch_flat_exact_paint *)paint)->depth, flat_span);
}
