/* leaf/vector128/gouraud.c: etch_kernel_gouraud by vectors, in place of
 * fragment/gouraud.c. */
#include "gouraud_rows.h"

void etch_kernel_gouraud(const struct etch_surface *surface, int16_t y0,
                         const struct etch_run *runs, uint8_t n, const struct etch_paint *paint)
{
    gouraud_rows(surface, y0, runs, n, (const struct etch_gouraud_paint *)paint, gouraud_plain);
}
