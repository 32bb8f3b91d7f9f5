/* fragment/flat_inverse_less.c: one colour where nearer, depths in a floating layout. See
 * inverse.h. */
#include "flat_span.h"
#include "inverse_rows.h"

void etch_kernel_flat_inverse_less(const struct etch_surface *surface, int16_t y0,
                                   const struct etch_run *runs, uint8_t n,
                                   const struct etch_paint *paint)
{
    etch_inverse_rows_less(surface, y0, runs, n, paint,
                           ((const struct etch_flat_inverse_paint *)paint)->up, flat_span);
}
