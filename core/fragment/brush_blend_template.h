/* fragment/brush_blend_template.h: the loop of the brush kernels with opacity; no part of the API.
 */
#ifndef ETCH_FRAGMENT_BRUSH_BLEND_TEMPLATE_H
#define ETCH_FRAGMENT_BRUSH_BLEND_TEMPLATE_H

#include "../base/rgb565.h"
#include "brush.h"

/* With x = s a + d (255 - a) + 128 <= 63 255 + 128, (x + x / 256) / 256 is (x - 1) / 255 rounded
 * down. Red and blue stay below 2^13 each, so one word holds both. */
ETCH_INLINE uint16_t brush_mix(uint32_t s, uint32_t d, uint32_t a)
{
    const uint32_t keep = 255 - a;
    uint32_t rb = (s >> 11 | (s & 31) << 16) * a + (d >> 11 | (d & 31) << 16) * keep +
                  UINT32_C(0x800080);
    uint32_t g = (s >> 5 & 63) * a + (d >> 5 & 63) * keep + 128;

    rb += rb >> 8 & UINT32_C(0xFF00FF);
    g += g >> 8;
    return (uint16_t)((rb & 0x1F00) << 3 | g >> 8 << 5 | rb >> 24);
}

/* Colours that are fetched at once. */
#define BRUSH_CHUNK 32

ETCH_INLINE void brush_row(const struct etch_surface *surface, int16_t x, int16_t y, uint16_t n,
                           const struct etch_brush_paint *p, bool swapped)
{
    uint16_t color[BRUSH_CHUNK];
    uint16_t *pixel = surface->pixels + etch_surface_index(surface, x, y);

    while (n != 0) {
        const uint16_t part = n < BRUSH_CHUNK ? n : BRUSH_CHUNK;

        p->brush->colors(p->brush, x, y, part, color);
        for (uint16_t i = 0; i < part; i++, pixel++) {
            const uint16_t d = swapped ? etch_rgb565_swap(*pixel) : *pixel;
            const uint16_t mixed = brush_mix(color[i], d, p->opacity);

            *pixel = swapped ? etch_rgb565_swap(mixed) : mixed;
        }
        n = (uint16_t)(n - part);
        x = (int16_t)(x + (int16_t)part);
    }
}

ETCH_INLINE void brush_runs(const struct etch_surface *surface, int16_t y0,
                            const struct etch_run *runs, uint8_t n, const struct etch_paint *paint,
                            bool swapped)
{
    for (uint8_t i = 0; i < n; i++)
        brush_row(surface, runs[i].x0, (int16_t)(y0 + i), (uint16_t)(runs[i].x1 - runs[i].x0),
                  (const struct etch_brush_paint *)paint, swapped);
}

#endif
