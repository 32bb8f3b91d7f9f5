/* draw/line_stipple.c: dotted lines. Called by applications. See line_stipple.h. */
#include "../fragment/flat.h"
#include "../fragment/pattern.h"
#include "../raster/line_runs.h"
#include "line_stipple.h"

static int32_t magnitude(int32_t v)
{
    return v < 0 ? -v : v;
}

void etch_line_stipple_runs(const struct etch_surface *s, int16_t x0, int16_t y0, int16_t x1,
                            int16_t y1, uint16_t pattern, const struct etch_paint *paint)
{
    const int32_t dx = (int32_t)x1 - x0, dy = (int32_t)y1 - y0;
    const bool steep = magnitude(dy) > magnitude(dx);
    const struct etch_line_stipple_paint stipple = {{etch_kernel_line_stipple},
                                                    paint,
                                                    pattern,
                                                    steep,
                                                    steep ? y0 : x0,
                                                    (int8_t)((steep ? dy : dx) < 0 ? -1 : 1)};

    etch_line_runs(s, x0, y0, x1, y1, &stipple.paint);
}

void etch_line_stipple_draw(const struct etch_surface *s, int16_t x0, int16_t y0, int16_t x1,
                            int16_t y1, uint16_t pattern, uint16_t color)
{
    const struct etch_flat_paint flat = {{etch_kernel_flat}, color};

    etch_line_stipple_runs(s, x0, y0, x1, y1, pattern, &flat.paint);
}
