/* raster/rect_outline.c: the border of a rectangle. Called by applications. See rect.h. */
#include "line.h"
#include "rect.h"

/* A far side beyond int16_t comes out of its cast at -32768 .. -3, where no surface has pixels. */
void etch_rect_draw(const struct etch_surface *s, int16_t x, int16_t y, int16_t w, int16_t h,
                    uint16_t color)
{
    if (w <= 0 || h <= 0)
        return;

    const int16_t right = (int16_t)((int32_t)x + w - 1), bottom = (int16_t)((int32_t)y + h - 1);
    const int16_t below = (int16_t)((int32_t)y + 1), inside = (int16_t)(h - 2);

    etch_hline_draw(s, x, y, w, color);
    if (h > 1)
        etch_hline_draw(s, x, bottom, w, color);
    etch_vline_draw(s, x, below, inside, color);
    if (w > 1)
        etch_vline_draw(s, right, below, inside, color);
}
