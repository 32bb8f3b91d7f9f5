/* frame/exchange_rows.h: walking two surfaces; no part of the API. */
#ifndef ETCH_FRAME_EXCHANGE_ROWS_H
#define ETCH_FRAME_EXCHANGE_ROWS_H

#include "exchange.h"

typedef void exchange_pixel(uint16_t *a, uint16_t *b);

ETCH_INLINE void exchange_walk(const struct etch_surface *a, const struct etch_surface *b,
                               exchange_pixel *step)
{
    const struct etch_rect area = etch_rect_intersect(a->clip, b->clip);

    if (etch_rect_is_empty(area))
        return;
    for (int16_t y = area.y0; y < area.y1; y++) {
        uint16_t *to = a->pixels + etch_surface_index(a, area.x0, y);
        uint16_t *const end = to + (area.x1 - area.x0);
        uint16_t *from = b->pixels + etch_surface_index(b, area.x0, y);

        while (to != end)
            step(to++, from++);
    }
}

#endif
