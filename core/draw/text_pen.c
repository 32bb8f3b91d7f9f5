/* draw/text_pen.c: the next glyph of a line. Called by all that measures and draws texts. */
#include "text_pen.h"

bool etch_pen_next(struct etch_pen *pen, const struct etch_font *font, const char **text,
                   const char *end)
{
    const uint16_t index = etch_font_find(font, etch_utf8_next(text, end));

    if (index == ETCH_NO_GLYPH)
        return false;
    if (font->kern != NULL && pen->index != ETCH_NO_GLYPH)
        pen->at = etch_pen_hold(pen->at + font->kern(font, pen->index, index));
    pen->index = index;
    pen->glyph = font->glyphs + index;
    return true;
}
