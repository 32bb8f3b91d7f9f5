/* frame/multisample_average.h: the loop of the resolves of four samples; no part of the API. */
#ifndef ETCH_FRAME_MULTISAMPLE_AVERAGE_H
#define ETCH_FRAME_MULTISAMPLE_AVERAGE_H

#include "pixel.h"

/* Pixels of `area`, inside `out` and the four planes of one layout that begin at plane[i]. */
ETCH_INLINE void multisample_average(const uint16_t *const plane[4],
                                     const struct etch_surface *layout,
                                     const struct etch_surface *out, struct etch_rect area,
                                     const bool swapped)
{
    if (etch_rect_is_empty(area))
        return;
    for (int16_t y = area.y0; y < area.y1; y++) {
        size_t at = etch_surface_index(layout, area.x0, y);
        uint16_t *pixel = out->pixels + etch_surface_index(out, area.x0, y);
        uint16_t *const end = pixel + (area.x1 - area.x0);

        for (; pixel != end; at++) {
            const uint32_t sum = pixel_spread(plane[0][at]) + pixel_spread(plane[1][at]) +
                                 pixel_spread(plane[2][at]) + pixel_spread(plane[3][at]);

            *pixel++ = pixel_ordered(pixel_join((sum + 2 * PIXEL_ONES) >> 2 & PIXEL_MASK), swapped);
        }
    }
}

#endif
