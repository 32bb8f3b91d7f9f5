/* raster/rows.c: the inside of shapes that know their rows. Called by ellipse.c, arc.c and the like. See
 * rows.h. */
#include "rows.h"
#include "run_band.h"

void etch_row_add(struct etch_row *row, int32_t x0, int32_t x1)
{
    struct etch_span *const last = &row->span[row->count > 0 ? row->count - 1 : 0];

    if (x0 >= x1)
        return;
    if (row->count > 0 && x0 <= last->x1) {
        if (x1 > last->x1)
            last->x1 = x1;
        return;
    }
    row->span[row->count].x0 = x0;
    row->span[row->count++].x1 = x1;
}

void etch_rows_fill(const struct etch_surface *surface, const struct etch_rows *rows,
                    const struct etch_paint *paint)
{
    const struct etch_rect *const clip = &surface->clip;
    const int32_t end = rows->bottom < clip->y1 ? rows->bottom + 1 : clip->y1;
    struct etch_run_band band;

    etch_run_band_init(&band, surface, paint);
    for (int32_t y = rows->top > clip->y0 ? rows->top : clip->y0; y < end; y++) {
        struct etch_row row;

        row.count = 0;
        rows->row(rows->shape, y, &row);
        for (uint8_t i = 0; i < row.count; i++)
            etch_run_band_add(&band, (int16_t)y, row.span[i].x0, row.span[i].x1);
        etch_run_band_row(&band, (int16_t)y);
    }
    etch_run_band_flush(&band);
}
