/* fragment/gouraud_inverse_less_swapped.c: interpolated colour where nearer, depths in a
 * floating layout, bytes swapped. See inverse.h. */
#include "gouraud_span.h"
#include "inverse_rows.h"

void etch_kernel_gouraud_inverse_less_swapped(const struct etch_surface *surface, int16_t y0,
                                              const struct etch_run *runs, uint8_t n,
                                              const struct etch_paint *paint)
{
    etch_inverse_rows_less(surface, y0, runs, n, paint,
                           ((const struct etch_gouraud_inverse_paint *)paint)->up,
                           etch_gouraud_span_swapped);
}
