/* fragment/gouraud_span.c: interpolated colour for a span. Called by the kernels with depth. See
 * gouraud_span.h. */
#include "gouraud_span.h"
#include "gouraud_rows.h"

void etch_gouraud_span(uint16_t *pixel, int32_t x, uint32_t n, int32_t y,
                       const struct etch_paint *paint)
{
    gouraud_span(pixel, x, n, y, (const struct etch_gouraud_paint *)paint, gouraud_pack);
}
