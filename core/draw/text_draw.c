/* draw/text_draw.c: a line of text. Called by applications and by what aligns and wraps lines. See
 * text.h. */
#include "text_pen.h"

int32_t etch_pen_draw(const struct etch_surface *s, const struct etch_text_style *style, int32_t x,
                      int32_t y, const char *text, const char *end)
{
    struct etch_pen pen = {x, NULL, ETCH_NO_GLYPH};

    while (!etch_utf8_ended(text, end)) {
        if (etch_pen_next(&pen, style->font, &text, end)) {
            const struct etch_glyph_box box = etch_pen_box(&pen, style->font, y);

            style->painter(s, style, &box);
            etch_pen_pass(&pen);
        }
    }
    return pen.at;
}

int32_t etch_text_draw(const struct etch_surface *s, const struct etch_text_style *style, int16_t x,
                       int16_t y, const char *text, const char *end)
{
    return etch_pen_draw(s, style, x, y, text, end) - x;
}
