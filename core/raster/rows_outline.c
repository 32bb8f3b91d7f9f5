/* raster/rows_outline.c: the border of shapes that know their rows. Called by the outlines of rings
 * and pies. See rows.h.
 *
 * A row without the pixels whose neighbours above, below, left and right are all in the shape:
 *
 *      above   ..########..
 *      row     .##########.   less  the spans, one pixel shorter at both ends, that are also above
 *      below   ..####..####         and below:  ...###..##..
 *      border  .##...##..##
 *
 * Most runs are a pixel or two, and a row has up to eight: each goes to the kernel alone, which is
 * no slower than sorting them into blocks, and needs no memory for them.
 */
#include "rows.h"

/* The end of what is known of column x in a row: the first column from x on that is not as x is. */
static int32_t until(const struct etch_row *row, int32_t x, bool *inside)
{
    for (uint8_t i = 0; i < row->count; i++) {
        *inside = row->span[i].x0 <= x;
        if (x < row->span[i].x0)
            return row->span[i].x0;
        if (x < row->span[i].x1)
            return row->span[i].x1;
    }
    *inside = false;
    return INT32_MAX;
}

static int32_t least(int32_t a, int32_t b)
{
    return a < b ? a : b;
}

/* The run that is being gathered. */
struct pen {
    const struct etch_surface *surface;
    const struct etch_paint *paint;
    int32_t y;
    struct etch_span span;
};

static void hand_over(const struct pen *pen)
{
    const struct etch_rect *const clip = &pen->surface->clip;
    const int32_t x0 = pen->span.x0 > clip->x0 ? pen->span.x0 : clip->x0;
    const int32_t x1 = least(pen->span.x1, clip->x1);
    const struct etch_run run = {(int16_t)x0, (int16_t)x1};

    if (x0 < x1)
        pen->paint->kernel(pen->surface, (int16_t)pen->y, &run, 1, pen->paint);
}

/* Columns right of those before, or next to them. */
static void add(struct pen *pen, int32_t x0, int32_t x1)
{
    if (x0 != pen->span.x1) {
        hand_over(pen);
        pen->span.x0 = x0;
    }
    pen->span.x1 = x1;
}

/* The border's part of one span: its ends, and between them where above or below has nothing. */
static void add_border(struct pen *pen, struct etch_span span, const struct etch_row *above,
                       const struct etch_row *below)
{
    int32_t x = span.x0 + 1;

    add(pen, span.x0, x);
    while (x < span.x1 - 1) {
        bool up, down;
        const int32_t end = least(least(until(above, x, &up), until(below, x, &down)), span.x1 - 1);

        if (!up || !down)
            add(pen, x, end);
        x = end;
    }
    if (x < span.x1)
        add(pen, x, span.x1);
}

static void get(const struct etch_rows *rows, int32_t y, struct etch_row *row)
{
    row->count = 0;
    if (y >= rows->top && y <= rows->bottom)
        rows->row(rows->shape, y, row);
}

void etch_rows_outline(const struct etch_surface *surface, const struct etch_rows *rows,
                       const struct etch_paint *paint)
{
    const struct etch_rect *const clip = &surface->clip;
    const int32_t end = rows->bottom < clip->y1 ? rows->bottom + 1 : clip->y1;
    int32_t y = rows->top > clip->y0 ? rows->top : clip->y0;
    struct pen pen = {surface, paint, y, {0, 0}};
    struct etch_row above, row, below;

    get(rows, y - 1, &above);
    get(rows, y, &row);
    for (; y < end; y++) {
        get(rows, y + 1, &below);
        pen.y = y;
        pen.span.x0 = pen.span.x1 = 0;
        for (uint8_t i = 0; i < row.count; i++)
            add_border(&pen, row.span[i], &above, &below);
        hand_over(&pen);
        above = row;
        row = below;
    }
}
