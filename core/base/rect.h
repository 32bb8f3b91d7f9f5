/* base/rect.h: half-open rectangles of pixels. */
#ifndef ETCH_BASE_RECT_H
#define ETCH_BASE_RECT_H

#include "fixed.h"

/* Pixels with x0 <= x < x1 and y0 <= y < y1. Empty where x1 <= x0 or y1 <= y0. */
struct etch_rect {
    int16_t x0, y0, x1, y1;
};

ETCH_INLINE bool etch_rect_is_empty(struct etch_rect r)
{
    return r.x1 <= r.x0 || r.y1 <= r.y0;
}

/* The pixels that a and b share; an empty result may have x1 < x0 or y1 < y0. */
ETCH_INLINE struct etch_rect etch_rect_intersect(struct etch_rect a, struct etch_rect b)
{
    const struct etch_rect r = {
        a.x0 > b.x0 ? a.x0 : b.x0,
        a.y0 > b.y0 ? a.y0 : b.y0,
        a.x1 < b.x1 ? a.x1 : b.x1,
        a.y1 < b.y1 ? a.y1 : b.y1,
    };
    return r;
}

/* The rectangle (x, y, w, h). w or h <= 0 gives an empty one. The far edge is taken in 32
 * bits and saturates at 32767, which loses only pixel column or row 32767: no surface
 * reaches it. */
ETCH_INLINE struct etch_rect etch_rect_from_size(int16_t x, int16_t y, int16_t w, int16_t h)
{
    const int32_t x1 = (int32_t)x + (w > 0 ? w : 0);
    const int32_t y1 = (int32_t)y + (h > 0 ? h : 0);
    const struct etch_rect r = {x, y, (int16_t)(x1 < INT16_MAX ? x1 : INT16_MAX),
                                (int16_t)(y1 < INT16_MAX ? y1 : INT16_MAX)};
    return r;
}

#endif
