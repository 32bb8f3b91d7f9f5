/* draw/text_break.c: where a line of a longer text ends. Called by text_box.c and by applications
 * that turn pages. See text.h. */
#include "text_pen.h"

static const char *skip_blanks(const char *text, const char *end)
{
    while (!etch_utf8_ended(text, end) && *text == ' ')
        text++;
    return text;
}

struct etch_text_line etch_text_break(const struct etch_font *font, int32_t width, const char *text,
                                      const char *end)
{
    struct etch_text_line line = {text, text, text, 0};
    struct etch_text_line word = line; /* up to the last break between words, if word.next moved */
    struct etch_pen pen = {0, NULL, ETCH_NO_GLYPH};
    bool blank = false;

    while (!etch_utf8_ended(line.next, end) && *line.next != '\n') {
        const char *next = line.next;
        const bool space = *next == ' ';

        if (space && !blank) {
            word = line; /* behind the last character of a word */
            word.next = next + 1;
        }
        blank = space;
        if (etch_pen_next(&pen, font, &next, end))
            etch_pen_pass(&pen);
        if (pen.at > width && !space && line.next != text) {
            if (word.next == text)
                return line;
            word.next = skip_blanks(word.next, end);
            return word;
        }
        line.end = line.next = next;
        line.width = pen.at;
    }
    if (blank) /* blanks at the end */
        line.end = word.end, line.width = word.width;
    if (!etch_utf8_ended(line.next, end))
        line.next++;
    return line;
}

int32_t etch_text_lines(const struct etch_font *font, int32_t width, const char *text,
                        const char *end)
{
    int32_t n = 0;

    for (; !etch_utf8_ended(text, end); n++)
        text = etch_text_break(font, width, text, end).next;
    return n;
}
