/* draw/text_box.c: text wrapped in a box. Called by applications. See text.h. */
#include "text_pen.h"

static int32_t place(const struct etch_rect *box, enum etch_align align, int32_t width)
{
    const int32_t room = (int32_t)box->x1 - box->x0 - width;

    return box->x0 + (align == ETCH_ALIGN_LEFT ? 0 : align == ETCH_ALIGN_CENTRE ? room >> 1 : room);
}

int32_t etch_text_box(const struct etch_surface *s, const struct etch_text_style *style,
                      struct etch_rect box, enum etch_align align, const char *text,
                      const char *end)
{
    const struct etch_font *font = style->font;
    struct etch_surface in = *s;
    int32_t top = box.y0, n = 0;

    in.clip = etch_rect_intersect(s->clip, box);
    for (; top < box.y1 && !etch_utf8_ended(text, end); n++, top += font->line) {
        const struct etch_text_line line = etch_text_break(font, (int32_t)box.x1 - box.x0, text,
                                                           end);

        if (top < in.clip.y1)
            (void)etch_pen_draw(&in, style, place(&box, align, line.width), top + font->ascent,
                                line.begin, line.end);
        text = line.next;
    }
    return n;
}
