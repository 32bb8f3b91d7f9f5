/* draw/text.h: text in bitmap fonts.
 *
 * A text style is a font, a colour and a glyph painter: like a paint, the painter is named, so that
 * only what is used is linked. The painter must fit the font's bits a pixel:
 *
 *      font     painter                  what it writes
 *      1 bit    etch_glyph_solid         the ink
 *      1 bit    etch_glyph_opaque        the ink, and `background` in the rest of the bitmap
 *      2 bits   etch_glyph_blend2        ink over what is there, by coverage 0/3 .. 3/3
 *      4 bits   etch_glyph_blend4        by coverage 0/15 .. 15/15
 *
 * Solid and opaque serve both byte orders; blend2_swapped and blend4_swapped are for surfaces in
 * rgb565_swapped. A blended channel is (ink a + there (15 - a)) / 15 rounded to the nearest once
 * (there are no ties); coverage 0 does not touch the pixel, full coverage writes the colour.
 *
 * Texts are UTF-8 from `text` to `end`, or to the NUL if end is NULL. Bad bytes count as U+FFFD,
 * and what the font lacks is drawn as its replacement (base/utf8.h, base/font.h): also line feeds,
 * which only the functions for boxes know. Pens are 32-bit and stop at +-2^30; every x and y is
 * legal. Inside a glyph each pixel is written once. Where bitmaps of neighbours overlap, as kerning
 * may make them, one is drawn over the other. A glyph outside the clip costs its place in the line,
 * a row of a glyph outside the clip nothing.
 *
 * On ARMv6-M a line of one letter of 9 x 15 in 1 bit takes 597 instructions (W14).
 */
#ifndef ETCH_DRAW_TEXT_H
#define ETCH_DRAW_TEXT_H

#include "../base/font.h"
#include "../base/surface.h"

/* A bitmap that begins at pixel (x, y) of the frame, in the format of base/font.h. */
struct etch_glyph_box {
    const uint8_t *bits;
    int32_t x, y;
    uint8_t width, height;
};

struct etch_text_style;

/* Draws a bitmap, clipped. */
typedef void etch_glyph_painter(const struct etch_surface *s, const struct etch_text_style *style,
                                const struct etch_glyph_box *box);

struct etch_text_style {
    const struct etch_font *font;
    etch_glyph_painter *painter;
    uint16_t color, background; /* in the surface's byte order; background: opaque only */
};

etch_glyph_painter etch_glyph_solid;
etch_glyph_painter etch_glyph_opaque;
etch_glyph_painter etch_glyph_blend2;
etch_glyph_painter etch_glyph_blend2_swapped;
etch_glyph_painter etch_glyph_blend4;
etch_glyph_painter etch_glyph_blend4_swapped;

/* One line, its first pen at x, baseline y: row y is the first below the letters that stand on it.
 * Returns how far the pen went, which is etch_text_width. */
int32_t etch_text_draw(const struct etch_surface *s, const struct etch_text_style *style, int16_t x,
                       int16_t y, const char *text, const char *end);

/* The same turned clockwise by `quarters` quarters (modulo 4) about the corner of pixels that the
 * pen is at: the line runs right, down, left, up. A glyph is turned in tiles of 16 x 16 on the
 * stack, 128 bytes. */
int32_t etch_text_draw_turned(const struct etch_surface *s, const struct etch_text_style *style,
                              int16_t x, int16_t y, uint8_t quarters, const char *text,
                              const char *end);

/* One line of cells: a cell is as wide as its glyph's advance and reaches from the ascent to the
 * descent. Every pixel of a cell is written once, ink or background, so that values change without
 * flicker. Ink outside its own cell is left out, and kerning is not used. The painter is given no
 * more than the part of a bitmap in its cell: use etch_glyph_opaque. Returns the sum of widths. */
int32_t etch_text_draw_cells(const struct etch_surface *s, const struct etch_text_style *style,
                             int16_t x, int16_t y, const char *text, const char *end);

/* How far the pen goes: the advances and the kerning between them. */
int32_t etch_text_width(const struct etch_font *font, const char *text, const char *end);

/* The rectangle of all bitmaps of the line, for a pen that starts at (0, 0); empty (0, 0, 0, 0) if
 * there are none. Saturated to int16. */
struct etch_rect etch_text_bounds(const struct etch_font *font, const char *text, const char *end);

/* Where a line stands about its x: it starts there, has its middle there (rounded to the left), or
 * ends there. */
enum etch_align {
    ETCH_ALIGN_LEFT,
    ETCH_ALIGN_CENTRE,
    ETCH_ALIGN_RIGHT
};

/* etch_text_draw, aligned about x. */
int32_t etch_text_draw_aligned(const struct etch_surface *s, const struct etch_text_style *style,
                               int16_t x, int16_t y, enum etch_align align, const char *text,
                               const char *end);

/* ---- lines in a box ---------------------------------------------------------------------- */

/* A line of a longer text. */
struct etch_text_line {
    const char *begin, *end; /* what is drawn */
    const char *next;        /* where the next line begins */
    int32_t width;           /* etch_text_width of begin .. end */
};

/* Finds the line that begins at `text`, which has not ended: up to a line feed, or as many words as
 * fit into `width` pixels; blanks at a break are left out. A word wider than `width` is broken
 * between characters; a line takes one character at least. */
struct etch_text_line etch_text_break(const struct etch_font *font, int32_t width, const char *text,
                                      const char *end);

/* How many lines the text takes in a box of this width; times font->line, its height. */
int32_t etch_text_lines(const struct etch_font *font, int32_t width, const char *text,
                        const char *end);

/* The text in lines of at most w pixels, the first with its ascent at row y, each aligned in the
 * box (x, y, w, h). Nothing outside the box is written. Returns the number of lines begun in it. */
int32_t etch_text_box(const struct etch_surface *s, const struct etch_text_style *style,
                      struct etch_rect box, enum etch_align align, const char *text,
                      const char *end);

#endif
