/* base/font.h: bitmap fonts as constants in flash.
 *
 * etch-font (ports/tools) writes them as C; a program links the fonts it names. A glyph is a bitmap
 * beside a pen on the baseline:
 *
 *            left
 *          |<-->+----------+ ^
 *          |    |  bitmap  | | top      rows above the baseline
 *      pen *----|----------|-v--------* next pen: advance, and kerning if the font has it
 *               +----------+
 *
 * Bitmaps are rows from the top, each of whole bytes, the left pixel in the highest bits: 1, 2 or 4
 * bits a pixel. On AVR constants lie in RAM: choose a small set of characters there.
 */
#ifndef ETCH_BASE_FONT_H
#define ETCH_BASE_FONT_H

#include "fixed.h"

struct etch_glyph {
    uint16_t bits;         /* offset of the bitmap in font->bits, bytes */
    uint8_t width, height; /* of the bitmap; 0 for blanks */
    int8_t left;           /* from the pen to its first column */
    int8_t top;            /* from the baseline up to its first row */
    uint8_t advance;       /* from this pen to the next */
};

/* Code points first .. first + count - 1 are glyphs glyph, glyph + 1, .. */
struct etch_font_range {
    uint32_t first;
    uint16_t count, glyph;
};

/* Glyph `right` after glyph `left` stands `by` pixels further on. */
struct etch_kern_pair {
    uint16_t left, right;
    int8_t by;
};

#define ETCH_NO_GLYPH UINT16_MAX

struct etch_font;

/* How far the pen moves between two glyphs. */
typedef int8_t etch_font_kern(const struct etch_font *font, uint16_t left, uint16_t right);

struct etch_font {
    const uint8_t *bits;
    const struct etch_glyph *glyphs;
    const struct etch_font_range *ranges; /* ascending, without overlap */
    etch_font_kern *kern;                 /* NULL without kerning, else etch_font_kern_pairs */
    const struct etch_kern_pair *pairs;   /* ascending by left, then right */
    uint16_t range_count, pair_count;
    uint16_t replacement;    /* the glyph of what the font has not, or ETCH_NO_GLYPH: nothing */
    uint8_t depth;           /* bits a pixel: 1, 2 or 4 */
    uint8_t ascent, descent; /* rows of a line above and below the baseline */
    uint8_t line;            /* from one baseline to the next */
};

/* The glyph of a code point, else the replacement. On ARMv6-M 15 instructions in the first range,
 * else a binary search: 40, and 12 a halving. */
uint16_t etch_font_find(const struct etch_font *font, uint32_t code);

/* Kerning by a binary search in font->pairs. Fonts with kerning name it, and so link it. */
etch_font_kern etch_font_kern_pairs;

#endif
