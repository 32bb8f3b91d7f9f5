/* fragment/flat.c: runs of one colour, without depth. See flat.h. */
#include "flat.h"
#include "../base/fill.h"

void etch_kernel_flat(const struct etch_surface *surface, int16_t y0, const struct etch_run *runs,
                      uint8_t n, const struct etch_paint *paint)
{
    const uint16_t color = ((const struct etch_flat_paint *)paint)->color;

    for (uint8_t i = 0; i < n; i++)
        etch_fill(surface->pixels + etch_surface_index(surface, runs[i].x0, (int16_t)(y0 + i)),
                  (uint16_t)(runs[i].x1 - runs[i].x0), color);
}
