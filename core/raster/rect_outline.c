/* raster/rect_outline.c: the border of a rectangle. Called by applications. See rect.h. */
#include "line.h"
#include "rect.h"

/* Columns and rows of the far sides may lie beyond int16_t, where nothing can be drawn. */
void etch_rect_draw(const struct etch_surface *s, int16_t x, int16_t y, int16_t w, int16_t h,
                    uint16_t color)
{
    const int32_t right = (int32_t)x + w - 1, bottom = (int32_t)y + h - 1;
    const int16_t inside = (int16_t)(h - 2);
    const int16_t below = (int16_t)(y < INT16_MAX ? y + 1 : y);

    if (w <= 0 || h <= 0)
        return;
    etch_hline_draw(s, x, y, w, color);
    if (h > 1 && bottom <= INT16_MAX)
        etch_hline_draw(s, x, (int16_t)bottom, w, color);
    etch_vline_draw(s, x, below, inside, color);
    if (w > 1 && right <= INT16_MAX)
        etch_vline_draw(s, (int16_t)right, below, inside, color);
}
