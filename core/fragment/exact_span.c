/* fragment/exact_span.c: exact colours of a span. Called by the exact kernels. See exact.h. */
#include "exact_color.h"

void etch_gouraud_exact_span(uint16_t *pixel, int32_t x, uint32_t n, int32_t y,
                             const struct etch_paint *paint)
{
    exact_span(pixel, x, n, y, (const struct etch_gouraud_exact_paint *)paint, false);
}
