/* frame/supersample_rows.h: the loop that the resolves share; no part of the API. */
#ifndef ETCH_FRAME_SUPERSAMPLE_ROWS_H
#define ETCH_FRAME_SUPERSAMPLE_ROWS_H

#include "pixel.h"
#include "supersample.h"

/* The average of n^2 spread pixels, 4, 9 or 16: at most 16 * 63 + 8 in a channel. Nine have no
 * ties, and v * 7282 >> 16 = v / 9 for v < 16384. */
ETCH_INLINE uint16_t supersample_average(uint32_t sum, const uint8_t n)
{
    if (n == 2)
        return pixel_join((sum + 2 * PIXEL_ONES) >> 2 & PIXEL_MASK);
    if (n == 4)
        return pixel_join((sum + 8 * PIXEL_ONES) >> 4 & PIXEL_MASK);
    sum += 4 * PIXEL_ONES;
    return pixel_pack(pixel_red(sum) * 7282 >> 16, pixel_green(sum) * 7282 >> 16,
                      pixel_blue(sum) * 7282 >> 16);
}

/* The pixels of out->clip that `large` holds all samples of. */
ETCH_INLINE struct etch_rect supersample_area(const struct etch_surface *large,
                                              const struct etch_surface *out, const uint8_t n)
{
    const struct etch_rect w = large->window;
    const struct etch_rect held = {(int16_t)(((int32_t)w.x0 + n - 1) / n),
                                   (int16_t)(((int32_t)w.y0 + n - 1) / n), (int16_t)(w.x1 / n),
                                   (int16_t)(w.y1 / n)};

    return etch_rect_intersect(held, out->clip);
}

ETCH_INLINE void supersample_resolve(const struct etch_surface *large,
                                     const struct etch_surface *out, const uint8_t n,
                                     const bool swapped)
{
    const struct etch_rect area = supersample_area(large, out, n);
    const size_t stride = large->stride;

    if (etch_rect_is_empty(area))
        return;
    for (int16_t y = area.y0; y < area.y1; y++) {
        const uint16_t *sample = large->pixels + etch_surface_index(large, (int16_t)(area.x0 * n),
                                                                    (int16_t)(y * n));
        uint16_t *pixel = out->pixels + etch_surface_index(out, area.x0, y);
        uint16_t *const end = pixel + (area.x1 - area.x0);

        for (; pixel != end; sample += n) {
            uint32_t sum = 0;

            const uint16_t *row = sample;

            ETCH_UNROLL(4)
            for (uint8_t j = 0; j < n; j++, row += stride) {
                ETCH_UNROLL(4)
                for (uint8_t i = 0; i < n; i++)
                    sum += pixel_spread(row[i]);
            }
            *pixel++ = pixel_ordered(supersample_average(sum, n), swapped);
        }
    }
}

#endif
