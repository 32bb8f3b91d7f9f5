/* base/font_kern.c: kerning by pairs. Named by fonts that have it, called between two glyphs of a
 * line. See font.h. */
#include "font.h"

static uint32_t key(uint16_t left, uint16_t right)
{
    return (uint32_t)left << 16 | right;
}

int8_t etch_font_kern_pairs(const struct etch_font *font, uint16_t left, uint16_t right)
{
    const uint32_t wanted = key(left, right);
    const struct etch_kern_pair *p = font->pairs;
    uint16_t n = font->pair_count;

    while (n != 0) {
        const uint16_t half = n >> 1;
        const uint32_t here = key(p[half].left, p[half].right);

        if (here == wanted)
            return p[half].by;
        if (here < wanted)
            p += half + 1, n = (uint16_t)(n - half - 1);
        else
            n = half;
    }
    return 0;
}
