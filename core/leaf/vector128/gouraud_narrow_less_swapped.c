/* leaf/vector128/gouraud_narrow_less_swapped.c: etch_gouraud_narrow_less_swapped by vectors, in
 * place of fragment/gouraud_narrow_less_swapped.c. Called by the kernel of that name. */
#include "narrow_rows.h"

void etch_gouraud_narrow_less_swapped(const struct etch_surface *surface, int16_t y0,
                                      const struct etch_run *runs, uint8_t n,
                                      const struct etch_paint *paint)
{
    narrow_rows(surface, y0, runs, n, (const struct etch_gouraud_paint *)paint, etch_depth_less,
                etch_rgb565_swap);
}
