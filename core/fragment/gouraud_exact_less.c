/* fragment/gouraud_exact_less.c: colours and depths correctly rounded, where
 * nearer. See exact.h. */
#include "exact.h"

void etch_kernel_gouraud_exact_less(const struct etch_surface *surface, int16_t y0,
                                    const struct etch_run *runs, uint8_t n,
                                    const struct etch_paint *paint)
{
    etch_depth_exact_rows_less(surface, y0, runs, n, paint,
                               &((const struct etch_gouraud_exact_paint *)paint)->depth,
                               etch_gouraud_exact_span);
}
