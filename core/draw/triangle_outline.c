/* draw/triangle_outline.c: three lines, each corner once. Called by applications. See shapes.h. */
#include "../raster/line.h"
#include "shapes.h"

void etch_triangle_draw(const struct etch_surface *s, int16_t x0, int16_t y0, int16_t x1,
                        int16_t y1, int16_t x2, int16_t y2, uint16_t color)
{
    const struct etch_point p[4] = {{x0, y0}, {x1, y1}, {x2, y2}, {x0, y0}};

    etch_polyline_draw(s, p, 4, color);
}
