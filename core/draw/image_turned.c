/* draw/image_turned.c: images mirrored and turned by quarters. Called by applications. See image.h.
 */
#include "image_parts.h"

/* With the last column and row at (c, r), pixel (i, j) of the turned image shows texel
 *
 *      none (i, j)   right (j, r - i)   half (c - i, r - j)   left (c - j, i)
 *
 * and of the mirror image the one in column c - u instead of u. */
void etch_image_draw_turned(const struct etch_surface *s, const struct etch_image_style *style,
                            int16_t x, int16_t y, enum etch_turn turn)
{
    const struct etch_rect all = etch_image_whole(style->image);
    const uint32_t quarters = (uint32_t)turn & 3, stride = style->image->stride;
    const bool mirrored = ((uint32_t)turn & ETCH_TURN_MIRROR) != 0;
    const bool from_right = (quarters >= 2) != mirrored,
               from_below = quarters == 1 || quarters == 2;
    const uint32_t column = from_right ? UINT32_MAX
                                       : 1; /* steps to the next column and row shown */
    const uint32_t row = from_below ? etch_wrap_sub(0, stride) : stride;
    struct etch_image_area area = {x, y, all.x1, all.y1, 0, column, row};

    if (etch_rect_is_empty(all))
        return;
    area.place = (from_below ? (uint32_t)(all.y1 - 1) * stride : 0) +
                 (from_right ? (uint32_t)(all.x1 - 1) : 0);
    if ((quarters & 1) != 0) {
        area.w = all.y1, area.h = all.x1;
        area.dx = row, area.dy = column;
    }
    etch_image_area_draw(s, style, &area);
}
