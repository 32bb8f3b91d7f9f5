/* draw/glyph_opaque.c: 1-bit glyphs in ink and background. Called for each glyph of a line. See
 * text.h. */
#include "text_columns.h"

static void both(const struct etch_glyph_column *c, const struct etch_text_style *style)
{
    const uint8_t *bits = c->bits;
    uintptr_t at = c->at;

    for (uint32_t rows = c->rows; rows != 0; rows--) {
        uint16_t *p = (uint16_t *)at; /* written where the mask is, inside the clip */

        for (uint32_t bit = 0x80; bit != 0; bit >>= 1, p++)
            if ((c->mask & bit) != 0)
                *p = (*bits & bit) != 0 ? style->color : style->background;
        bits += c->pitch;
        at = etch_wrap_address_add(at, c->step);
    }
}

void etch_glyph_opaque(const struct etch_surface *s, const struct etch_text_style *style,
                       const struct etch_glyph_box *box)
{
    ETCH_ASSERT(style->font->depth == 1);
    etch_glyph_columns(s, style, box, both);
}
