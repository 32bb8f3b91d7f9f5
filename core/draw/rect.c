/* draw/rect.c: rectangles in one colour. Called by applications. See shapes.h. */
#include "../base/fill.h"
#include "shapes.h"

void etch_rect_fill(const struct etch_surface *s, int16_t x, int16_t y, int16_t w, int16_t h,
                    uint16_t color)
{
    const struct etch_rect r = etch_rect_intersect(etch_rect_from_size(x, y, w, h), s->clip);

    if (!etch_rect_is_empty(r))
        etch_fill_rows(s->pixels + etch_surface_index(s, r.x0, r.y0), (uint32_t)(r.x1 - r.x0),
                       color, (uint32_t)(r.y1 - r.y0), s->stride);
}
