/* draw/rect_small.c: rectangles in little flash. Called by applications. See shapes_small.h. */
#include "shapes_small.h"

void etch_rect_fill_small(const struct etch_surface *s, int16_t x, int16_t y, int16_t w, int16_t h,
                          uint16_t color)
{
    const int32_t bottom = (int32_t)y + h, y1 = bottom < s->clip.y1 ? bottom : s->clip.y1;

    for (int32_t row = y > s->clip.y0 ? y : s->clip.y0; row < y1; row++)
        etch_span_fill_small(s, row, x, (int32_t)x + w, color);
}
