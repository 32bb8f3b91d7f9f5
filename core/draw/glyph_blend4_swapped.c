/* draw/glyph_blend4_swapped.c: glyphs of 4 bits a pixel over what is there, byte-swapped. Called
 * for each glyph of a line. See text.h. */
#include "text_blend.h"

void etch_glyph_blend4_swapped(const struct etch_surface *s, const struct etch_text_style *style,
                               const struct etch_glyph_box *box)
{
    etch_glyph_blend(s, style, box, 4, true);
}
