/* frame/move_parts.h: what copying and scrolling share; no part of the API. */
#ifndef ETCH_FRAME_MOVE_PARTS_H
#define ETCH_FRAME_MOVE_PARTS_H

#include "move.h"

/* Half-open, in numbers that hold the sum of two coordinates. */
struct etch_area {
    int32_t x0, y0, x1, y1;
};

ETCH_INLINE bool etch_area_is_empty(const struct etch_area *a)
{
    return a->x1 <= a->x0 || a->y1 <= a->y0;
}

/* Copies area + (dx, dy) on `to` from area on `from`, |dx| and |dy| <= 65535, as far as `from`
 * holds it and inside `into`, which is inside the window of `to`. Returns what was written; may be
 * empty. */
struct etch_area etch_move(const struct etch_surface *to, struct etch_rect into,
                           const struct etch_surface *from, struct etch_rect area, int32_t dx,
                           int32_t dy);

#endif
