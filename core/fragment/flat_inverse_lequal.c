/* fragment/flat_inverse_lequal.c: one colour where not farther, depths in a floating layout. See
 * inverse.h. */
#include "flat_span.h"
#include "inverse_rows.h"

void etch_kernel_flat_inverse_lequal(const struct etch_surface *surface, int16_t y0,
                                     const struct etch_run *runs, uint8_t n,
                                     const struct etch_paint *paint)
{
    etch_inverse_rows_lequal(surface, y0, runs, n, paint,
                             ((const struct etch_flat_inverse_paint *)paint)->up, flat_span);
}
