/* raster/rows.c: the inside of shapes that know their rows. Called by ellipse.c, arc.c and the
 * like. See rows.h. */
#include "rows.h"

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

/* Runs of rows that have equally many, the first ones of all, then the second ones, .. as in
 * run_band.h. What comes as a row of spans needs no second place to gather it; twelve runs keep the
 * shapes that stand on this within 512 bytes of stack and cost up to 4 % more instructions than 32.
 */
#define BLOCK 12
struct block {
    struct etch_run run[BLOCK];
    int32_t y;     /* of the first row */
    uint8_t lanes; /* runs of each row, up to ETCH_ROW_SPANS */
    uint8_t rows, most;
};

/* Cuts the spans to the clip's columns and leaves out what is empty. */
static void clip_row(struct etch_row *row, const struct etch_rect *clip)
{
    uint8_t count = 0;

    for (uint8_t i = 0; i < row->count; i++) {
        const struct etch_span s = row->span[i];

        row->span[count].x0 = s.x0 > clip->x0 ? s.x0 : clip->x0;
        row->span[count].x1 = s.x1 < clip->x1 ? s.x1 : clip->x1;
        if (row->span[count].x0 < row->span[count].x1)
            count++;
    }
    row->count = count;
}

static void hand_over(const struct etch_surface *surface, struct block *b,
                      const struct etch_paint *paint)
{
    const struct etch_run *run = b->run;

    if (b->rows != 0)
        for (uint8_t i = 0; i < b->lanes; i++, run += b->most)
            paint->kernel(surface, (int16_t)b->y, run, b->rows, paint);
    b->rows = 0;
}

static void begin(struct block *b, int32_t y, uint8_t lanes)
{
    b->y = y;
    b->lanes = lanes;
    b->most = lanes == 1 ? BLOCK : lanes == 2 ? BLOCK / 2 : BLOCK / 3;
}

void etch_rows_fill(const struct etch_surface *surface, const struct etch_rows *rows,
                    const struct etch_paint *paint)
{
    const struct etch_rect *const clip = &surface->clip;
    const int32_t end = rows->bottom < clip->y1 ? rows->bottom + 1 : clip->y1;
    struct block b;

    b.rows = b.lanes = b.most = 0;
    for (int32_t y = rows->top > clip->y0 ? rows->top : clip->y0; y < end; y++) {
        struct etch_row row;
        struct etch_run *run;

        row.count = 0;
        rows->row(rows->shape, y, &row);
        clip_row(&row, clip);
        if (row.count != b.lanes || b.rows == b.most) {
            hand_over(surface, &b, paint);
            begin(&b, y, row.count);
        }
        run = b.run + b.rows;
        for (uint8_t i = 0; i < row.count; i++, run += b.most) {
            run->x0 = (int16_t)row.span[i].x0;
            run->x1 = (int16_t)row.span[i].x1;
        }
        b.rows++;
    }
    hand_over(surface, &b, paint);
}
