/* raster/stretched.c: the rows of ellipses and rounded rectangles. Called by ellipse.c and
 * round_rect.c. See stretched.h. */
#include "stretched.h"

bool etch_stretched_init(struct etch_stretched *p, const struct etch_surface *s, int32_t rx,
                         int32_t ry)
{
    if (!etch_oval_init(&p->oval, p->x0, p->x1, rx, ry, etch_rows_seen(s)))
        return false;
    etch_oval_edge_init(&p->edge);
    etch_oval_edge_init(&p->outer);
    return true;
}

int32_t etch_stretched_box(struct etch_stretched *p, int16_t x, int16_t y, int16_t w, int16_t h,
                           int16_t r)
{
    const int32_t most = ((w < h ? w : h) - 1) / 2;
    const int32_t radius = r < 0 ? 0 : r < most ? r : most;

    if (w <= 0 || h <= 0)
        return -1;
    p->x0 = x + radius;
    p->y0 = y + radius;
    p->x1 = (int32_t)x + w - 1 - radius;
    p->y1 = (int32_t)y + h - 1 - radius;
    return radius;
}

/* How far row y is from the box. */
static int32_t off(const struct etch_stretched *p, int32_t y)
{
    return y < p->y0 ? p->y0 - y : y > p->y1 ? y - p->y1 : 0;
}

static void inside(void *shape, int32_t y, struct etch_row *row)
{
    struct etch_stretched *const p = shape;
    const int32_t w = etch_oval_width(&p->oval, &p->edge, off(p, y));

    etch_row_add(row, p->x0 - w, p->x1 + w + 1);
}

/* Off the border are the columns less than w from the box's, and no further than the neighbour rows
 * reach. */
static void border(void *shape, int32_t y, struct etch_row *row)
{
    struct etch_stretched *const p = shape;
    const int32_t b = off(p, y), w = etch_oval_width(&p->oval, &p->edge, b);
    const int32_t beyond = y > p->y0 && y < p->y1 ? w : etch_oval_width(&p->oval, &p->outer, b + 1);
    const int32_t hole = beyond < w ? beyond : w - 1;

    if (beyond < 0) {
        etch_row_add(row, p->x0 - w, p->x1 + w + 1);
        return;
    }
    etch_row_add(row, p->x0 - w, p->x0 - hole);
    etch_row_add(row, p->x1 + hole + 1, p->x1 + w + 1);
}

static struct etch_rows rows(struct etch_stretched *p, etch_row_function *row)
{
    const struct etch_rows r = {row, p, p->y0 - p->oval.ry, p->y1 + p->oval.ry};

    return r;
}

void etch_stretched_fill(const struct etch_surface *s, struct etch_stretched *p,
                         const struct etch_paint *paint)
{
    const struct etch_rows r = rows(p, inside);

    etch_rows_fill(s, &r, paint);
}

void etch_stretched_outline(const struct etch_surface *s, struct etch_stretched *p,
                            const struct etch_paint *paint)
{
    const struct etch_rows r = rows(p, border);

    etch_rows_fill(s, &r, paint);
}
