/* draw/text_blend.h: glyphs of 2 and 4 bits a pixel over what is there; no part of the API. Each
 * painter is this template with constant arguments. */
#ifndef ETCH_DRAW_TEXT_BLEND_H
#define ETCH_DRAW_TEXT_BLEND_H

#include "../base/rgb565.h"
#include "text_clip.h"

/* round((c a + d (15 - a)) / 15) a channel, a = 1 .. 14; no ties, 15 is odd. Red and blue share a
 * word: x + 1 = 31 15 + 7 + 1 at most, and (y + y / 16 + y / 256) / 16 is x / 15 rounded down for
 * x <= 472. Green: x <= 952, where (273 x + 128) / 4096 is. Both tried for every x. */
ETCH_INLINE uint16_t etch_glyph_mix(uint16_t color, uint16_t there, uint32_t a)
{
    const uint32_t c = color, d = there, keep = 15 - a;
    const uint32_t rb = (c >> 11 | (c & 31) << 16) * a + (d >> 11 | (d & 31) << 16) * keep +
                        UINT32_C(0x00080008);
    const uint32_t g = (c >> 5 & 63) * a + (d >> 5 & 63) * keep + 7;
    const uint32_t q = (rb + (rb >> 4 & UINT32_C(0x0FFF0FFF)) + (rb >> 8 & UINT32_C(0x00FF00FF))) >>
                       4;

    return (uint16_t)((q & 31) << 11 | (g * 273 + 128) >> 12 << 5 | (q >> 16 & 31));
}

/* The row of a bitmap from pixel i on, n pixels, to p. */
ETCH_INLINE void etch_glyph_blend_row(uint16_t *p, const uint8_t *bits, uint32_t i, uint32_t n,
                                      uint16_t native, uint32_t depth, bool swapped)
{
    const uint32_t per_byte = 8 / depth, most = (1U << depth) - 1;

    for (; n != 0; n--, i++, p++) {
        const uint32_t shift = 8 - depth - i % per_byte * depth;
        const uint32_t a = ((uint32_t)bits[i / per_byte] >> shift & most) * (15 / most);

        if (a == 0)
            continue;
        const uint16_t there = swapped ? etch_rgb565_swap(*p) : *p;
        const uint16_t mixed = a == 15 ? native : etch_glyph_mix(native, there, a);

        *p = swapped ? etch_rgb565_swap(mixed) : mixed;
    }
}

ETCH_INLINE void etch_glyph_blend(const struct etch_surface *s, const struct etch_text_style *style,
                                  const struct etch_glyph_box *box, uint32_t depth, bool swapped)
{
    const uint32_t pitch = (box->width * depth + 7) >> 3;
    const uint16_t native = swapped ? etch_rgb565_swap(style->color) : style->color;
    struct etch_glyph_part part;

    ETCH_ASSERT(style->font->depth == depth);
    if (!etch_glyph_clip(&part, s, box))
        return;
    const uint32_t from = (uint32_t)(part.x0 - box->x), n = (uint32_t)(part.x1 - part.x0);
    const uint8_t *bits = box->bits + (uint32_t)(part.y0 - box->y) * pitch;
    uint16_t *p = s->pixels + etch_surface_index(s, (int16_t)part.x0, (int16_t)part.y0);
    uint32_t rows = (uint32_t)(part.y1 - part.y0);

    for (;;) {
        etch_glyph_blend_row(p, bits, from, n, native, depth, swapped);
        if (--rows == 0)
            return;
        bits += pitch;
        p += s->stride;
    }
}

#endif
