/* fragment/gouraud_less_swapped.c: interpolated colour where nearer than the depth plane,
 * bytes swapped. See gouraud.h. */
#include "gouraud_narrow.h"

void etch_kernel_gouraud_less_swapped(const struct etch_surface *surface, int16_t y0,
                                      const struct etch_run *runs, uint8_t n,
                                      const struct etch_paint *paint)
{
    if (gouraud_is_narrow(runs, n))
        etch_gouraud_narrow_less_swapped(surface, y0, runs, n, paint);
    else
        etch_depth_rows_less(surface, y0, runs, n, paint, etch_gouraud_span_swapped);
}
