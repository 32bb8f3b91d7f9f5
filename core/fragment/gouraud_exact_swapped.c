/* fragment/gouraud_exact_swapped.c: colours correctly rounded, bytes swapped. See exact.h. */
#include "exact_color.h"

void etch_kernel_gouraud_exact_swapped(const struct etch_surface *surface, int16_t y0,
                                       const struct etch_run *runs, uint8_t n,
                                       const struct etch_paint *paint)
{
    exact_rows(surface, y0, runs, n, paint, etch_gouraud_exact_span_swapped);
}
