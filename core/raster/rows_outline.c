/* raster/rows_outline.c: the border of shapes that know their rows. Called by the outlines of rings and
 * pies. See rows.h.
 *
 * A row without the pixels whose neighbours above, below, left and right are all in the shape:
 *
 *  above   ..########..
 *  row     .##########.     less  the spans, one pixel shorter at both ends, that are also above
 *  below   ..####..####           and below:  ...###..##..
 *  border  .##...##..##
 */
#include "rows.h"
#include "run_band.h"

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

/* The border's part of one span: its ends, and between them where above or below has nothing. */
static void add_border(struct etch_run_band *band, int32_t y, struct etch_span span,
                       const struct etch_row *above, const struct etch_row *below)
{
    int32_t x = span.x0 + 1;

    etch_run_band_add(band, (int16_t)y, span.x0, x);
    while (x < span.x1 - 1) {
        bool up, down;
        const int32_t end = least(least(until(above, x, &up), until(below, x, &down)), span.x1 - 1);

        if (!up || !down)
            etch_run_band_add(band, (int16_t)y, x, end);
        x = end;
    }
    if (x < span.x1)
        etch_run_band_add(band, (int16_t)y, x, span.x1);
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
    struct etch_run_band band;
    struct etch_row above, row, below;

    etch_run_band_init(&band, surface, paint);
    get(rows, y - 1, &above);
    get(rows, y, &row);
    for (; y < end; y++) {
        get(rows, y + 1, &below);
        for (uint8_t i = 0; i < row.count; i++)
            add_border(&band, y, row.span[i], &above, &below);
        etch_run_band_row(&band, (int16_t)y);
        above = row;
        row = below;
    }
    etch_run_band_flush(&band);
}
