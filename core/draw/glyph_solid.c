/* draw/glyph_solid.c: 1-bit glyphs in one colour. Called for each glyph of a line. See text.h. */
#include "text_columns.h"

/* Three instructions a pixel, four where there is ink (ARMv6-M, gcc 12), four pixels at once where
 * there is none: W14. */
static void ink(const struct etch_glyph_column *c, const struct etch_text_style *style)
{
    const uint8_t *bits = c->bits;
    const uintptr_t step = c->step;
    const uint32_t mask = c->mask, pitch = c->pitch;
    const uint16_t color = style->color;
    uintptr_t at = c->at;
    uint32_t rows = c->rows;

    do {
        uint16_t *const p = (uint16_t *)at; /* written where the mask is, inside the clip */
        const uint32_t b = *bits & mask;

        if ((b & 0xF0) != 0) {
            if ((b & 0x80) != 0)
                p[0] = color;
            if ((b & 0x40) != 0)
                p[1] = color;
            if ((b & 0x20) != 0)
                p[2] = color;
            if ((b & 0x10) != 0)
                p[3] = color;
        }
        if ((b & 0x0F) != 0) {
            if ((b & 0x08) != 0)
                p[4] = color;
            if ((b & 0x04) != 0)
                p[5] = color;
            if ((b & 0x02) != 0)
                p[6] = color;
            if ((b & 0x01) != 0)
                p[7] = color;
        }
        bits += pitch;
        at = etch_wrap_address_add(at, step);

    } while (--rows != 0);
}

void etch_glyph_solid(const struct etch_surface *s, const struct etch_text_style *style,
                      const struct etch_glyph_box *box)
{
    ETCH_ASSERT(style->font->depth == 1);
    etch_glyph_columns(s, style, box, ink);
}
