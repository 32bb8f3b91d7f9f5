/* raster/straight.c: horizontal and vertical lines. Called by applications and by rectangle
 * outlines. See line.h. */
#include "../base/fill.h"
#include "line.h"

void etch_hline_draw(const struct etch_surface *s, int16_t x, int16_t y, int16_t w, uint16_t color)
{
    const struct etch_rect r = etch_rect_intersect(etch_rect_from_size(x, y, w, 1), s->clip);

    if (!etch_rect_is_empty(r))
        etch_fill_rows(s->pixels + etch_surface_index(s, r.x0, r.y0), (uint32_t)(r.x1 - r.x0),
                       color, 1, 0);
}

void etch_vline_draw(const struct etch_surface *s, int16_t x, int16_t y, int16_t h, uint16_t color)
{
    const struct etch_rect r = etch_rect_intersect(etch_rect_from_size(x, y, 1, h), s->clip);
    uint16_t *p;

    if (etch_rect_is_empty(r))
        return;
    p = s->pixels + etch_surface_index(s, r.x0, r.y0);
    for (int16_t n = (int16_t)(r.y1 - r.y0); n > 0; n--, p += s->stride)
        *p = color;
}
