/* fragment/brush.c: runs of a brush's colours. Shapes call it through a paint. See brush.h. */
#include "brush.h"

void etch_kernel_brush(const struct etch_surface *surface, int16_t y0, const struct etch_run *runs,
                       uint8_t n, const struct etch_paint *paint)
{
    const struct etch_brush *const brush = ((const struct etch_brush_paint *)paint)->brush;

    for (uint8_t i = 0; i < n; i++) {
        const int16_t y = (int16_t)(y0 + i), x = runs[i].x0;

        if (x < runs[i].x1)
            brush->colors(brush, x, y, (uint16_t)(runs[i].x1 - x),
                          surface->pixels + etch_surface_index(surface, x, y));
    }
}
