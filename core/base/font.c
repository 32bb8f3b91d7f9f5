/* base/font.c: finds glyphs. Called for each character of a text that is measured or drawn. See
 * font.h. */
#include "font.h"

uint16_t etch_font_find(const struct etch_font *font, uint32_t code)
{
    const struct etch_font_range *r = font->ranges;
    uint16_t n = font->range_count;

    if (n != 0 && code >= r->first && code - r->first < r->count) /* often ASCII */
        return (uint16_t)(r->glyph + (code - r->first));
    while (n > 1) { /* the range, if there is one, is among r[0 .. n-1] */
        const uint16_t half = n >> 1;

        if (r[half].first <= code)
            r += half, n = (uint16_t)(n - half);
        else
            n = half;
    }
    if (n == 0 || code < r->first || code - r->first >= r->count)
        return font->replacement;
    return (uint16_t)(r->glyph + (code - r->first));
}
