/* fragment/gouraud_dither_lequal.c: dithered colour where not farther. See
 * dither.h. */
#include "dither.h"

void etch_kernel_gouraud_dither_lequal(const struct etch_surface *surface, int16_t y0,
                                       const struct etch_run *runs, uint8_t n,
                                       const struct etch_paint *paint)
{
    etch_depth_rows_lequal(surface, y0, runs, n, paint, etch_gouraud_dither_span);
}
