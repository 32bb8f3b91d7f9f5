/* frame/rect_xor.c: rectangles that take themselves away again. Called by applications. See
 * move.h. */
#include "move.h"

void etch_rect_xor(const struct etch_surface *s, int16_t x, int16_t y, int16_t w, int16_t h,
                   uint16_t mask)
{
    const struct etch_rect r = etch_rect_intersect(etch_rect_from_size(x, y, w, h), s->clip);

    if (etch_rect_is_empty(r))
        return;
    for (int16_t row = r.y0; row < r.y1; row++) {
        uint16_t *p = s->pixels + etch_surface_index(s, r.x0, row);

        for (uint16_t *const end = p + (r.x1 - r.x0); p != end; p++)
            *p = (uint16_t)(*p ^ mask);
    }
}
