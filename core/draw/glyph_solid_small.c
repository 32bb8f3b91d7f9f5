/* draw/glyph_solid_small.c: 1-bit glyphs in one colour, in little flash. Called for each glyph of a
 * line. See text_small.h. */
#include "text_small.h"

#include "text_clip.h"

void etch_glyph_solid_small(const struct etch_surface *s, const struct etch_text_style *style,
                            const struct etch_glyph_box *box)
{
    const uint16_t pitch = (uint16_t)((box->width + 7) >> 3);
    struct etch_glyph_part part;

    ETCH_ASSERT(style->font->depth == 1);
    if (!etch_glyph_clip(&part, s, box))
        return;
    for (; part.y0 < part.y1; part.y0++) {
        const uint8_t *const row = box->bits + (size_t)(part.y0 - box->y) * pitch;
        uint16_t *p = s->pixels + etch_surface_index(s, (int16_t)part.x0, (int16_t)part.y0);

        for (int32_t i = part.x0 - box->x; i < part.x1 - box->x; i++, p++)
            if (((uint32_t)row[i >> 3] << (i & 7) & 0x80) != 0)
                *p = style->color;
    }
}
