/* draw/text_align.c: lines aligned about a point. Called by applications. See text.h. */
#include "text_pen.h"

int32_t etch_text_draw_aligned(const struct etch_surface *s, const struct etch_text_style *style,
                               int16_t x, int16_t y, enum etch_align align, const char *text,
                               const char *end)
{
    const int32_t width = align == ETCH_ALIGN_LEFT ? 0 : etch_text_width(style->font, text, end);
    const int32_t from = x - (align == ETCH_ALIGN_CENTRE ? (width + 1) >> 1 : width);

    return etch_pen_draw(s, style, from, y, text, end) - from;
}
