/* leaf/vector128/gouraud_swapped.c: etch_kernel_gouraud_swapped by vectors, in place of
 * fragment/gouraud_swapped.c. */
#include "gouraud_rows.h"

void etch_kernel_gouraud_swapped(const struct etch_surface *surface, int16_t y0,
                                 const struct etch_run *runs, uint8_t n,
                                 const struct etch_paint *paint)
{
    gouraud_rows(surface, y0, runs, n, (const struct etch_gouraud_paint *)paint, gouraud_swapped);
}
