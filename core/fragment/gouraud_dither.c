/* fragment/gouraud_dither.c: interpolated colour, dithered. See dither.h. */
#include "dither.h"

void etch_kernel_gouraud_dither(const struct etch_surface *surface, int16_t y0,
                                const struct etch_run *runs, uint8_t n,
                                const struct etch_paint *paint)
{
    for (uint8_t i = 0; i < n; i++, y0++) {
        const int16_t x = runs[i].x0;

        if (x != runs[i].x1)
            etch_gouraud_dither_span(surface->pixels + etch_surface_index(surface, x, y0), x,
                                     (uint32_t)(runs[i].x1 - x), y0, paint);
    }
}
