/* fragment/exact_span_swapped.c: exact colours of a span, bytes swapped. Called by the exact
 * kernels. See exact.h. */
#include "exact_color.h"

void etch_gouraud_exact_span_swapped(uint16_t *pixel, int32_t x, uint32_t n, int32_t y,
                                     const struct etch_paint *paint)
{
    exact_span(pixel, x, n, y, (const struct etch_gouraud_exact_paint *)paint, true);
}
