/* fragment/gouraud_less.c: interpolated colour where nearer than the depth plane.
 * See gouraud.h. */
#include "gouraud_narrow.h"

void etch_kernel_gouraud_less(const struct etch_surface *surface, int16_t y0,
                              const struct etch_run *runs, uint8_t n,
                              const struct etch_paint *paint)
{
    if (gouraud_is_narrow(runs, n))
        etch_gouraud_narrow_less(surface, y0, runs, n, paint);
    else
        etch_depth_rows_less(surface, y0, runs, n, paint, etch_gouraud_span);
}
