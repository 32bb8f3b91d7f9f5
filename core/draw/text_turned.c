/* draw/text_turned.c: lines turned by quarters. Called by applications. See text.h. */
#include "text_pen.h"

#define TILE 16

/* The pixels of a bitmap from (column, row) on, TILE x TILE at most, turned into a bitmap of its
 * own. */
struct tile {
    const struct etch_glyph_box *glyph;
    uint8_t column, row, width, height;
    uint8_t depth, quarters;
};

/* Moves one pixel of the tile to where the turn takes it. */
static void move(uint8_t *out, uint32_t pitch, const struct tile *t, uint8_t i, uint8_t j)
{
    const uint32_t depth = t->depth, glyph_pitch = (t->glyph->width * depth + 7) >> 3;
    const uint32_t bit = (uint32_t)(t->column + i) * depth;
    const uint8_t *bits = t->glyph->bits + (uint32_t)(t->row + j) * glyph_pitch;
    const uint32_t value = (uint32_t)bits[bit >> 3] << (bit & 7) & 0xFF & (0xFF00U >> depth);
    const uint32_t back_i = t->width - 1U - i, back_j = t->height - 1U - j;
    const uint32_t x = t->quarters == 1 ? back_j : t->quarters == 2 ? back_i : j;
    const uint32_t y = t->quarters == 1 ? i : t->quarters == 2 ? back_j : back_i;

    out[y * pitch + (x * depth >> 3)] |= (uint8_t)(value >> (x * depth & 7));
}

/* Where the pixel corner (u, v) of the line, seen from the first pen, goes. */
static void turn(int32_t *x, int32_t *y, int32_t u, int32_t v, uint8_t quarters)
{
    *x = quarters == 1 ? -v : quarters == 2 ? -u : v;
    *y = quarters == 1 ? u : quarters == 2 ? -v : -u;
}

static void draw_tile(const struct etch_surface *s, const struct etch_text_style *style, int32_t x,
                      int32_t y, const struct tile *t)
{
    const bool upright = t->quarters == 2;
    const int32_t u = t->glyph->x + t->column, v = t->glyph->y + t->row;
    uint8_t out[TILE * TILE / 2] = {0};
    struct etch_glyph_box box = {out, 0, 0, upright ? t->width : t->height,
                                 upright ? t->height : t->width};
    const uint32_t pitch = ((uint32_t)box.width * t->depth + 7) >> 3;

    turn(&box.x, &box.y, u + (t->quarters == 1 ? 0 : t->width),
         v + (t->quarters == 3 ? 0 : t->height), t->quarters);
    box.x += x, box.y += y;
    if (box.x >= s->clip.x1 || box.y >= s->clip.y1 || box.x + box.width <= s->clip.x0 ||
        box.y + box.height <= s->clip.y0)
        return;
    for (uint8_t j = 0; j < t->height; j++)
        for (uint8_t i = 0; i < t->width; i++)
            move(out, pitch, t, i, j);
    style->painter(s, style, &box);
}

static uint8_t up_to(int32_t n)
{
    return (uint8_t)(n < TILE ? n : TILE);
}

static void draw_glyph(const struct etch_surface *s, const struct etch_text_style *style, int32_t x,
                       int32_t y, const struct etch_glyph_box *box, uint8_t quarters)
{
    for (int32_t row = 0; row < box->height; row += TILE) {
        for (int32_t column = 0; column < box->width; column += TILE) {
            const struct tile t = {.glyph = box,
                                   .column = (uint8_t)column,
                                   .row = (uint8_t)row,
                                   .width = up_to(box->width - column),
                                   .height = up_to(box->height - row),
                                   .depth = style->font->depth,
                                   .quarters = quarters};

            draw_tile(s, style, x, y, &t);
        }
    }
}

int32_t etch_text_draw_turned(const struct etch_surface *s, const struct etch_text_style *style,
                              int16_t x, int16_t y, uint8_t quarters, const char *text,
                              const char *end)
{
    struct etch_pen pen = {0, NULL, ETCH_NO_GLYPH};

    quarters &= 3;
    if (quarters == 0)
        return etch_text_draw(s, style, x, y, text, end);
    while (!etch_utf8_ended(text, end)) {
        if (etch_pen_next(&pen, style->font, &text, end)) {
            const struct etch_glyph_box box = etch_pen_box(&pen, style->font, 0);

            draw_glyph(s, style, x, y, &box, quarters);
            etch_pen_pass(&pen);
        }
    }
    return pen.at;
}
