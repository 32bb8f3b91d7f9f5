/* raster/point.c: one pixel. Called by applications and polylines. See line.h. */
#include "line.h"

void etch_point_draw(const struct etch_surface *s, int16_t x, int16_t y, uint16_t color)
{
    if (x >= s->clip.x0 && x < s->clip.x1 && y >= s->clip.y0 && y < s->clip.y1)
        s->pixels[etch_surface_index(s, x, y)] = color;
}
