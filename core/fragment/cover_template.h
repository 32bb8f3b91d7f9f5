/* fragment/cover_template.h: the loop of the kernels that blend by cover; no part of the API. */
#ifndef ETCH_FRAGMENT_COVER_TEMPLATE_H
#define ETCH_FRAGMENT_COVER_TEMPLATE_H

#include "../base/rgb565.h"
#include "cover.h"

#define COVER_WHOLE (UINT32_C(255) * ETCH_COVER_ONE)

/* The numerator is below 64 W < 2^26; of W the power of two goes first, which leaves m < 2^14 and
 * m / 255 = m 32897 2^-23. */
ETCH_INLINE uint32_t cover_mix(uint32_t s, uint32_t d, uint32_t w)
{
    return ((s * w + d * (COVER_WHOLE - w) + COVER_WHOLE / 2) >> 12) * 32897 >> 23;
}

ETCH_INLINE uint16_t cover_pixel(uint16_t s, uint16_t d, uint32_t w)
{
    const uint32_t r = cover_mix((uint32_t)s >> 11, (uint32_t)d >> 11, w);
    const uint32_t g = cover_mix((uint32_t)s >> 5 & 63, (uint32_t)d >> 5 & 63, w);
    const uint32_t b = cover_mix((uint32_t)s & 31, (uint32_t)d & 31, w);

    return (uint16_t)(r << 11 | g << 5 | b);
}

ETCH_INLINE void cover_row(const struct etch_surface *surface, int16_t x, int16_t y, uint16_t n,
                           const int16_t *cover, const struct etch_cover_paint *paint, bool swapped)
{
    const struct etch_cover_flat_paint *const p = (const struct etch_cover_flat_paint *)paint;
    const uint16_t color = p->color, full = swapped ? etch_rgb565_swap(color) : color;
    const uint32_t opacity = p->opacity;
    uint16_t *pixel = surface->pixels + etch_surface_index(surface, x, y);

    for (const int16_t *const end = cover + n; cover != end; cover++, pixel++) {
        const uint32_t w = (uint32_t)*cover * opacity;
        uint16_t d;

        if (w == COVER_WHOLE) {
            *pixel = full;
            continue;
        }
        d = cover_pixel(color, swapped ? etch_rgb565_swap(*pixel) : *pixel, w);
        *pixel = swapped ? etch_rgb565_swap(d) : d;
    }
}

#endif
