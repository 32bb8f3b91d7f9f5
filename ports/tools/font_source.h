/* ports/tools/font_source.h: a font on its way to C. etch_font.c (BDF) and etch_font_ttf.c
 * (FreeType) fill it in, font_source.c trims, packs and writes it. */
#ifndef ETCH_TOOLS_FONT_SOURCE_H
#define ETCH_TOOLS_FONT_SOURCE_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

#define FONT_SIDE 128    /* most columns and rows of a bitmap */
#define FONT_GLYPHS 4096 /* most glyphs */
#define FONT_PAIRS 20000 /* most pairs with kerning */

struct font_glyph {
    uint32_t code;
    int width, height, left, top, advance; /* as base/font.h */
    uint8_t *level;                        /* width * height coverages, 0 .. 2^depth - 1 */
};

struct font_source {
    int depth, ascent, descent, line;
    int count, pair_count;
    struct font_glyph glyph[FONT_GLYPHS];
    struct font_pair {
        int left, right, by; /* numbers of glyphs once they are sorted */
    } pair[FONT_PAIRS];
};

/* True if `code` is in a list like "32-126,0xA0-0xFF,8592". */
bool font_set_has(const char *set, uint32_t code);

/* Says what is wrong on stderr and ends the program with status 2. */
_Noreturn void font_fail(const char *what, const char *detail);

/* An empty glyph with room for width x height coverages. */
struct font_glyph *font_add(struct font_source *f, uint32_t code, int width, int height);

/* Sorts by code point and takes empty rows and columns away. */
void font_finish(struct font_source *f);

/* The C file of `struct etch_font NAME`. `header`: how it includes base/font.h; `from`: a comment.
 */
void font_write(FILE *out, const struct font_source *f, const char *name, const char *header,
                const char *from);

#endif
