/* fragment/gouraud_dither_less.c: dithered colour where nearer. See
 * dither.h. */
#include "dither.h"

void etch_kernel_gouraud_dither_less(const struct etch_surface *surface, int16_t y0,
                                     const struct etch_run *runs, uint8_t n,
                                     const struct etch_paint *paint)
{
    etch_depth_rows_less(surface, y0, runs, n, paint, etch_gouraud_dither_span);
}
