/* fragment/gouraud_narrow_less.c: short runs of interpolated colour where
 * nearer. Called by the kernel of that name. See gouraud_narrow.h. */
#include "gouraud_narrow.h"

void etch_gouraud_narrow_less(const struct etch_surface *surface, int16_t y0,
                              const struct etch_run *runs, uint8_t n,
                              const struct etch_paint *paint)
{
    gouraud_narrow(surface, y0, runs, n, (const struct etch_gouraud_paint *)paint, etch_depth_less,
                   gouraud_pack);
}
