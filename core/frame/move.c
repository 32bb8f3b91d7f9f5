/* frame/move.c: rectangles to another place. Called by copies and scrolls. See move.h. */
#include "../base/copy.h"
#include "move_parts.h"

static int32_t greater(int32_t a, int32_t b)
{
    return a > b ? a : b;
}

static int32_t less(int32_t a, int32_t b)
{
    return a < b ? a : b;
}

struct etch_area etch_move(const struct etch_surface *to, struct etch_rect into,
                           const struct etch_surface *from, struct etch_rect area, int32_t dx,
                           int32_t dy)
{
    const struct etch_rect held = etch_rect_intersect(area, from->window);
    const struct etch_area out = {greater(held.x0 + dx, into.x0), greater(held.y0 + dy, into.y0),
                                  less(held.x1 + dx, into.x1), less(held.y1 + dy, into.y1)};

    if (etch_area_is_empty(&out))
        return out;
    const struct etch_copy copy = {
        .to = to->pixels + etch_surface_index(to, (int16_t)out.x0, (int16_t)out.y0),
        .from = from->pixels +
                etch_surface_index(from, (int16_t)(out.x0 - dx), (int16_t)(out.y0 - dy)),
        .to_stride = to->stride,
        .from_stride = from->stride,
    };

    etch_copy_rows(&copy, (uint32_t)(out.x1 - out.x0), (uint32_t)(out.y1 - out.y0));
    return out;
}

void etch_surface_copy_rect(const struct etch_surface *to, int16_t x, int16_t y,
                            const struct etch_surface *from, struct etch_rect area)
{
    ETCH_ASSERT(to != NULL && from != NULL);
    (void)etch_move(to, to->clip, from, area, (int32_t)x - area.x0, (int32_t)y - area.y0);
}
