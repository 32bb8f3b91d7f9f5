/* frame/scroll.c: an area's content by a distance. Called by applications. See move.h. */
#include "../base/fill.h"
#include "move_parts.h"

static void fill(const struct etch_surface *s, int32_t x0, int32_t y0, int32_t x1, int32_t y1,
                 uint16_t color)
{
    if (x0 < x1 && y0 < y1)
        etch_fill_rows(s->pixels + etch_surface_index(s, (int16_t)x0, (int16_t)y0),
                       (uint32_t)(x1 - x0), color, (uint32_t)(y1 - y0), s->stride);
}

void etch_surface_scroll(const struct etch_surface *s, struct etch_rect area, int16_t dx,
                         int16_t dy, uint16_t color)
{
    const struct etch_rect all = etch_rect_intersect(area, s->clip);
    struct etch_area moved;

    ETCH_ASSERT(s != NULL);
    if (etch_rect_is_empty(all))
        return;
    moved = etch_move(s, all, s, area, dx, dy);
    if (etch_area_is_empty(&moved)) {
        fill(s, all.x0, all.y0, all.x1, all.y1, color);
        return;
    }
    fill(s, all.x0, all.y0, all.x1, moved.y0, color);
    fill(s, all.x0, moved.y0, moved.x0, moved.y1, color);
    fill(s, moved.x1, moved.y0, all.x1, moved.y1, color);
    fill(s, all.x0, moved.y1, all.x1, all.y1, color);
}
