/* draw/text_width.c: how long a line is. Called by applications and alignment. See text.h. */
#include "text_pen.h"

int32_t etch_text_width(const struct etch_font *font, const char *text, const char *end)
{
    struct etch_pen pen = {0, NULL, ETCH_NO_GLYPH};

    while (!etch_utf8_ended(text, end))
        if (etch_pen_next(&pen, font, &text, end))
            etch_pen_pass(&pen);
    return pen.at;
}
