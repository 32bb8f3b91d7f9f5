/* draw/text_pen.h: walking along a line of text; no part of the API. */
#ifndef ETCH_DRAW_TEXT_PEN_H
#define ETCH_DRAW_TEXT_PEN_H

#include "../base/utf8.h"
#include "text.h"

#define ETCH_PEN_LIMIT (INT32_C(1) << 30)

/* The pen on the way along a line. Start with {x, NULL, ETCH_NO_GLYPH}. */
struct etch_pen {
    int32_t at;                     /* where the glyph stands */
    const struct etch_glyph *glyph; /* the latest, or NULL */
    uint16_t index;                 /* its number, or ETCH_NO_GLYPH */
};

ETCH_INLINE int32_t etch_pen_hold(int32_t at)
{
    return at > ETCH_PEN_LIMIT ? ETCH_PEN_LIMIT : at < -ETCH_PEN_LIMIT ? -ETCH_PEN_LIMIT : at;
}

/* Takes the next character of a line that has not ended: pen->glyph then stands at pen->at. False
 * if the font has nothing for it; the pen stays. */
bool etch_pen_next(struct etch_pen *pen, const struct etch_font *font, const char **text,
                   const char *end);

/* Goes behind the latest glyph; an advance is not negative. */
ETCH_INLINE void etch_pen_pass(struct etch_pen *pen)
{
    const int32_t at = pen->at + pen->glyph->advance;

    pen->at = at < ETCH_PEN_LIMIT ? at : ETCH_PEN_LIMIT;
}

/* Its bitmap about the baseline y. */
ETCH_INLINE struct etch_glyph_box etch_pen_box(const struct etch_pen *pen,
                                               const struct etch_font *font, int32_t y)
{
    const struct etch_glyph *g = pen->glyph;
    const struct etch_glyph_box box = {font->bits + g->bits, pen->at + g->left, y - g->top,
                                       g->width, g->height};
    return box;
}

/* Draws a line whose first pen is (x, y); for pens that do not fit int16. Returns the last pen. */
int32_t etch_pen_draw(const struct etch_surface *s, const struct etch_text_style *style, int32_t x,
                      int32_t y, const char *text, const char *end);

#endif
