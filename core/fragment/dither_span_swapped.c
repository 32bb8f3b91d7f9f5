/* fragment/dither_span_swapped.c: dithered colours of a span, bytes swapped. Called by the dithered
 * kernels. See dither.h. */
#include "dither_rows.h"

void etch_gouraud_dither_span_swapped(uint16_t *pixel, int32_t x, uint32_t n, int32_t y,
                                      const struct etch_paint *paint)
{
    dither_span(pixel, x, n, y, (const struct etch_gouraud_paint *)paint, gouraud_pack_swapped);
}
