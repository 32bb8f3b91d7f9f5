/* draw/text_columns.h: 1-bit glyphs by columns of 8 pixels; no part of the API.
 *
 * A bitmap is walked in columns of one byte: the address of a row steps by a constant, and the clip
 * to the left and right is a mask, one instruction a row.
 */
#ifndef ETCH_DRAW_TEXT_COLUMNS_H
#define ETCH_DRAW_TEXT_COLUMNS_H

#include "text_clip.h"

/* One byte in each of `rows` rows; bits of `mask` may be written. `at` is the address of the pixel
 * of the highest bit: a number, since masked pixels may lie outside the plane. */
struct etch_glyph_column {
    const uint8_t *bits;
    uintptr_t at, step; /* step: bytes from one row of pixels to the next */
    uint32_t rows;
    uint8_t mask, pitch; /* pitch: bytes from one row of bits to the next */
};

typedef void etch_glyph_column_painter(const struct etch_glyph_column *column,
                                       const struct etch_text_style *style);

ETCH_INLINE void etch_glyph_columns(const struct etch_surface *s,
                                    const struct etch_text_style *style,
                                    const struct etch_glyph_box *box,
                                    etch_glyph_column_painter *paint)
{
    struct etch_glyph_part p;

    if (!etch_glyph_clip(&p, s, box))
        return;
    const uint8_t pitch = (uint8_t)((box->width + 7) >> 3);
    const uint8_t first = (uint8_t)((p.x0 - box->x) >> 3);
    const size_t down = (size_t)(p.y0 - box->y) * pitch + first;
    int32_t x = box->x + 8 * first;
    struct etch_glyph_column c = {
        .bits = box->bits + down,
        .at = etch_wrap_address_add(etch_surface_row(s, s->pixels, (int16_t)p.y0),
                                    (uintptr_t)(intptr_t)(x * 2)),
        .step = (uintptr_t)s->stride * 2,
        .rows = (uint32_t)(p.y1 - p.y0),
        .pitch = pitch,
    };

    for (; x < p.x1; x += 8, c.bits++, c.at = etch_wrap_address_add(c.at, 16)) {
        const uint32_t left = x < p.x0 ? UINT32_C(0xFF) >> (p.x0 - x) : 0xFF;
        const uint32_t right = p.x1 - x < 8 ? UINT32_C(0xFF00) >> (p.x1 - x) : 0xFF;

        c.mask = (uint8_t)(left & right);
        paint(&c, style);
    }
}

#endif
