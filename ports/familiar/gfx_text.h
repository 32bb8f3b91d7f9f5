/* ports/familiar/gfx_text.h: text under familiar names: cells of 6 x 8 pixels times the text
 * size, placed by their upper left pixel, as the classic font of Adafruit GFX and font 1 of
 * TFT_eSPI. Cells, wrapping and bounds are theirs to the pixel; the letters are those of
 * etch_font_fixed_5x8_ascii. For better faces, smooth ones among them, use draw/text.h on
 * &g->surface beside these. */
#ifndef ETCH_PORTS_FAMILIAR_GFX_TEXT_H
#define ETCH_PORTS_FAMILIAR_GFX_TEXT_H

#include "gfx.h"

#ifdef __cplusplus
extern "C" {
#endif

#include "../../core/fonts/fonts.h"

enum {
    GFX_CELL_WIDTH = 6,
    GFX_CELL_HEIGHT = 8,
    GFX_BASELINE = 7 /* row of a cell that is the first below the letters */
};

/* What of a text stands at drawString's x and y, in TFT_eSPI's numbers. */
enum gfx_datum {
    TL_DATUM,
    TC_DATUM,
    TR_DATUM,
    ML_DATUM,
    MC_DATUM,
    MR_DATUM,
    BL_DATUM,
    BC_DATUM,
    BR_DATUM
};

ETCH_INLINE void gfx_setCursor(struct gfx *g, int16_t x, int16_t y)
{
    g->cursor_x = x;
    g->cursor_y = y;
}

ETCH_INLINE void gfx_setTextSize(struct gfx *g, uint8_t size)
{
    g->size_x = g->size_y = size > 0 ? size : 1;
}

/* Letters alone. */
ETCH_INLINE void gfx_setTextColor(struct gfx *g, uint16_t color)
{
    g->text_color = g->text_background = color;
}

/* Letters, and the rest of their cells. */
ETCH_INLINE void gfx_setTextColorOn(struct gfx *g, uint16_t color, uint16_t background)
{
    g->text_color = color;
    g->text_background = background;
}

ETCH_INLINE void gfx_setTextWrap(struct gfx *g, bool wrap)
{
    g->wrap = wrap;
}

ETCH_INLINE void gfx_setTextDatum(struct gfx *g, uint8_t datum)
{
    g->datum = datum;
}

/* The rectangle of `size` pixels that pixel (i, j) of a cell at (x, y) becomes. */
ETCH_INLINE void gfx_dot(struct gfx *g, int16_t x, int16_t y, int i, int j, int w, int h,
                         uint8_t size_x, uint8_t size_y, uint16_t color)
{
    const int32_t x0 = x + (int32_t)i * size_x, y0 = y + (int32_t)j * size_y;

    gfx_fill(g, gfx_area(x0, y0, x0 + (int32_t)w * size_x, y0 + (int32_t)h * size_y), color);
}

/* One character with its upper left pixel at (x, y); `background` other than `color` fills the
 * rest of the cell. */
ETCH_INLINE void gfx_drawChar(struct gfx *g, int16_t x, int16_t y, unsigned char c, uint16_t color,
                              uint16_t background, uint8_t size_x, uint8_t size_y)
{
    const struct etch_font *const font = &etch_font_fixed_5x8_ascii;
    const uint16_t number = etch_font_find(font, c);

    if (background != color)
        gfx_dot(g, x, y, 0, 0, GFX_CELL_WIDTH, GFX_CELL_HEIGHT, size_x, size_y, background);
    if (number != ETCH_NO_GLYPH) {
        const struct etch_glyph *const glyph = &font->glyphs[number];
        const uint8_t *const bits = font->bits + glyph->bits;
        const unsigned stride = (glyph->width + 7U) / 8;

        for (unsigned j = 0; j < glyph->height; j++)
            for (unsigned i = 0; i < glyph->width; i++)
                if ((bits[j * stride + i / 8] >> (7 - (i & 7)) & 1) != 0)
                    gfx_dot(g, x, y, (int)i + glyph->left, (int)j + GFX_BASELINE - glyph->top, 1, 1,
                            size_x, size_y, color);
    }
}

/* Where the next character of `size` goes, at most 32767. */
ETCH_INLINE int16_t gfx_forward(int16_t at, int cells, uint8_t size)
{
    const int32_t next = at + (int32_t)cells * size;

    return (int16_t)(next < INT16_MAX ? next : INT16_MAX);
}

/* The place of character c after what moved the pen to (*x, *y); false if it has none (a line
 * feed, a carriage return). */
ETCH_INLINE bool gfx_place(const struct gfx *g, char c, int16_t *x, int16_t *y)
{
    const bool ends = g->wrap && *x + (int32_t)GFX_CELL_WIDTH * g->size_x > gfx_width(g);

    if (c == '\n' || (c != '\r' && ends)) {
        *x = 0;
        *y = gfx_forward(*y, GFX_CELL_HEIGHT, g->size_y);
    }
    return c != '\n' && c != '\r';
}

/* A character at the cursor, which goes on. */
ETCH_INLINE void gfx_write(struct gfx *g, char c)
{
    if (gfx_place(g, c, &g->cursor_x, &g->cursor_y)) {
        gfx_drawChar(g, g->cursor_x, g->cursor_y, (unsigned char)c, g->text_color,
                     g->text_background, g->size_x, g->size_y);
        g->cursor_x = gfx_forward(g->cursor_x, GFX_CELL_WIDTH, g->size_x);
    }
}

ETCH_INLINE void gfx_print(struct gfx *g, const char *text)
{
    while (*text != '\0')
        gfx_write(g, *text++);
}

ETCH_INLINE void gfx_println(struct gfx *g, const char *text)
{
    gfx_print(g, text);
    gfx_write(g, '\n');
}

/* A number in a base of 2 to 36, else 10; below 0 with a minus in front, in base 10 only: in
 * others as the 32 bits that it has. */
ETCH_INLINE void gfx_printNumber(struct gfx *g, int32_t value, uint8_t base)
{
    const bool below = base == 10 && value < 0;
    uint32_t left = below ? etch_wrap_sub(0, (uint32_t)value) : (uint32_t)value;
    char digits[34];
    uint8_t n = 0;

    if (base < 2 || base > 36) {
        gfx_printNumber(g, value, 10);
        return;
    }
    do {
        const uint32_t digit = left % base;

        digits[n++] = (char)(digit < 10 ? '0' + digit : 'A' + digit - 10);
        left /= base;
    } while (left != 0);
    if (below)
        digits[n++] = '-';
    while (n > 0)
        gfx_write(g, digits[--n]);
}

/* The rectangle of the cells of a text that begins at (x, y); w and h are 0 if it has none. */
ETCH_INLINE void gfx_getTextBounds(const struct gfx *g, const char *text, int16_t x, int16_t y,
                                   int16_t *x1, int16_t *y1, uint16_t *w, uint16_t *h)
{
    int32_t left = INT16_MAX, top = INT16_MAX, right = -1, bottom = -1;
    bool any = false;

    *x1 = x;
    *y1 = y;
    for (; *text != '\0'; text++)
        if (gfx_place(g, *text, &x, &y)) {
            const int32_t end = x + (int32_t)GFX_CELL_WIDTH * g->size_x;
            const int32_t below = y + (int32_t)GFX_CELL_HEIGHT * g->size_y;

            left = x < left ? x : left;
            top = y < top ? y : top;
            right = !any || end > right ? end : right;
            bottom = !any || below > bottom ? below : bottom;
            any = true;
            x = gfx_forward(x, GFX_CELL_WIDTH, g->size_x);
        }
    if (any) {
        *x1 = (int16_t)left;
        *y1 = (int16_t)top;
    }
    *w = (uint16_t)(any ? right - left : 0);
    *h = (uint16_t)(any ? bottom - top : 0);
}

/* ---- drawString ------------------------------------------------------------------------------ */

ETCH_INLINE int16_t gfx_fontHeight(const struct gfx *g)
{
    return (int16_t)(GFX_CELL_HEIGHT * g->size_y);
}

ETCH_INLINE int16_t gfx_textWidth(const struct gfx *g, const char *text)
{
    int16_t width = 0;

    while (*text++ != '\0')
        width = gfx_forward(width, GFX_CELL_WIDTH, g->size_x);
    return width;
}

/* One line about (x, y) by the datum, where halves are rounded down; the cursor stays. Returns its
 * width. */
ETCH_INLINE int16_t gfx_drawString(struct gfx *g, const char *text, int16_t x, int16_t y)
{
    const uint8_t datum = g->datum <= BR_DATUM ? g->datum : (uint8_t)TL_DATUM;
    const int16_t width = gfx_textWidth(g, text);
    int32_t at = x - (int32_t)width * (datum % 3) / 2;
    const int32_t top = y - (int32_t)gfx_fontHeight(g) * (datum / 3) / 2;

    for (; *text != '\0' && at <= INT16_MAX; text++, at += (int32_t)GFX_CELL_WIDTH * g->size_x)
        if (at >= INT16_MIN && top >= INT16_MIN)
            gfx_drawChar(g, (int16_t)at, (int16_t)top, (unsigned char)*text, g->text_color,
                         g->text_background, g->size_x, g->size_y);
    return width;
}

#ifdef __cplusplus
}
#endif

#endif
