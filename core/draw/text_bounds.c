/* draw/text_bounds.c: what a line covers. Called by applications that repaint. See text.h. */
#include "text_pen.h"

static int16_t hold(int32_t v)
{
    return (int16_t)(v > INT16_MAX ? INT16_MAX : v < INT16_MIN ? INT16_MIN : v);
}

static void take(struct etch_rect *r, const struct etch_glyph_box *box)
{
    const int16_t x0 = hold(box->x), x1 = hold(box->x + box->width);
    const int16_t y0 = hold(box->y), y1 = hold(box->y + box->height);

    if (r->x1 <= r->x0) { /* the first */
        r->x0 = x0, r->x1 = x1, r->y0 = y0, r->y1 = y1;
        return;
    }
    r->x0 = x0 < r->x0 ? x0 : r->x0;
    r->x1 = x1 > r->x1 ? x1 : r->x1;
    r->y0 = y0 < r->y0 ? y0 : r->y0;
    r->y1 = y1 > r->y1 ? y1 : r->y1;
}

struct etch_rect etch_text_bounds(const struct etch_font *font, const char *text, const char *end)
{
    struct etch_pen pen = {0, NULL, ETCH_NO_GLYPH};
    struct etch_rect r = {0, 0, 0, 0};

    while (!etch_utf8_ended(text, end)) {
        if (etch_pen_next(&pen, font, &text, end)) {
            const struct etch_glyph_box box = etch_pen_box(&pen, font, 0);

            if (box.width != 0 && box.height != 0)
                take(&r, &box);
            etch_pen_pass(&pen);
        }
    }
    return r;
}
