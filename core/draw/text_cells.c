/* draw/text_cells.c: text with its background, each pixel once. Called by applications. See text.h.
 */
#include "shapes.h"
#include "text_pen.h"

/* A rectangle of which only what is inside the clip counts. */
static void fill(const struct etch_surface *s, int32_t x0, int32_t y0, int32_t x1, int32_t y1,
                 uint16_t color)
{
    const struct etch_rect *c = &s->clip;

    x0 = x0 > c->x0 ? x0 : c->x0;
    y0 = y0 > c->y0 ? y0 : c->y0;
    x1 = x1 < c->x1 ? x1 : c->x1;
    y1 = y1 < c->y1 ? y1 : c->y1;
    if (x0 < x1 && y0 < y1)
        etch_rect_fill(s, (int16_t)x0, (int16_t)y0, (int16_t)(x1 - x0), (int16_t)(y1 - y0), color);
}

static int32_t hold(int32_t v, int32_t least, int32_t most)
{
    return v < least ? least : v > most ? most : v;
}

static int16_t narrow(int32_t v)
{
    return (int16_t)hold(v, INT16_MIN, INT16_MAX);
}

/* The bitmap inside its cell and the four rectangles round it. */
static void cell(const struct etch_surface *s, const struct etch_text_style *style,
                 const struct etch_pen *pen, int32_t y)
{
    const struct etch_glyph_box box = etch_pen_box(pen, style->font, y);
    const int32_t left = pen->at, right = left + pen->glyph->advance;
    const int32_t top = y - style->font->ascent, below = y + style->font->descent;
    const int32_t x0 = hold(box.x, left, right), x1 = hold(box.x + box.width, left, right);
    const int32_t y0 = hold(box.y, top, below), y1 = hold(box.y + box.height, top, below);
    const struct etch_rect inside = {narrow(left), narrow(top), narrow(right), narrow(below)};
    const uint16_t color = style->background;
    struct etch_surface in = *s;

    in.clip = etch_rect_intersect(s->clip, inside);
    style->painter(&in, style, &box);
    fill(s, left, top, right, y0, color);
    fill(s, left, y0, x0, y1, color);
    fill(s, x1, y0, right, y1, color);
    fill(s, left, y1, right, below, color);
}

int32_t etch_text_draw_cells(const struct etch_surface *s, const struct etch_text_style *style,
                             int16_t x, int16_t y, const char *text, const char *end)
{
    struct etch_pen pen = {x, NULL, ETCH_NO_GLYPH};

    while (!etch_utf8_ended(text, end)) {
        if (etch_pen_next(&pen, style->font, &text, end)) {
            cell(s, style, &pen, y);
            etch_pen_pass(&pen);
        }
        pen.index = ETCH_NO_GLYPH; /* no kerning */
    }
    return pen.at - x;
}
