/* frame/accumulation_divide.h: the walk of the two returns; no part of the API. */
#ifndef ETCH_FRAME_ACCUMULATION_DIVIDE_H
#define ETCH_FRAME_ACCUMULATION_DIVIDE_H

#include "accumulation_rows.h"

ETCH_INLINE void accumulation_divide(const struct etch_accumulation *a,
                                     const struct etch_surface *s, uint16_t divisor,
                                     const bool swapped)
{
    const struct etch_rect area = etch_rect_intersect(a->window, s->clip);
    const int32_t half = divisor / 2;

    if (etch_rect_is_empty(area) || divisor == 0)
        return;
    const struct pixel_divisor d = pixel_divisor(divisor);

    for (int16_t y = area.y0; y < area.y1; y++) {
        uint16_t *pixel = s->pixels + etch_surface_index(s, area.x0, y);
        uint16_t *const end = pixel + (area.x1 - area.x0);

        for (const uint16_t *sum = accumulation_at(a, area.x0, y); pixel != end; sum += 3)
            *pixel++ = pixel_ordered(pixel_pack(pixel_divide(sum[0] + half, d, 31),
                                                pixel_divide(sum[1] + half, d, 63),
                                                pixel_divide(sum[2] + half, d, 31)),
                                     swapped);
    }
}

#endif
