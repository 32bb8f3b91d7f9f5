/* fragment/cover_brush_template.h: the loop of the kernels that blend a brush by cover; no part of
 * the API. */
#ifndef ETCH_FRAGMENT_COVER_BRUSH_TEMPLATE_H
#define ETCH_FRAGMENT_COVER_BRUSH_TEMPLATE_H

#include "brush.h"
#include "cover_template.h"

/* Colours that are fetched at once. */
#define COVER_CHUNK 32

ETCH_INLINE void cover_brush_row(const struct etch_surface *surface, int16_t x, int16_t y,
                                 uint16_t n, const int16_t *cover,
                                 const struct etch_cover_brush_paint *p, bool swapped)
{
    uint16_t color[COVER_CHUNK];
    uint16_t *pixel = surface->pixels + etch_surface_index(surface, x, y);

    while (n != 0) {
        const uint16_t part = n < COVER_CHUNK ? n : COVER_CHUNK;

        p->brush->colors(p->brush, x, y, part, color);
        for (uint16_t i = 0; i < part; i++, pixel++) {
            const uint32_t w = (uint32_t)*cover++ * p->opacity;
            const uint16_t d = swapped ? etch_rgb565_swap(*pixel) : *pixel;
            const uint16_t mixed = cover_pixel(color[i], d, w);

            *pixel = swapped ? etch_rgb565_swap(mixed) : mixed;
        }
        n = (uint16_t)(n - part);
        x = (int16_t)(x + (int16_t)part);
    }
}

#endif
