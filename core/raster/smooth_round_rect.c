/* raster/smooth_round_rect.c: smooth rounded rectangles and their frames. Called by applications.
 * See smooth_shapes.h. */
#include "smooth_lines.h"

struct box {
    int32_t x0, y0, x1, y1, r;
};

static int32_t least(int32_t a, int32_t b)
{
    return a < b ? a : b;
}

static struct box box_of(struct etch_point_q8 a, struct etch_point_q8 b, int32_t r)
{
    struct box box = {least(a.x, b.x), least(a.y, b.y), a.x < b.x ? b.x : a.x,
                      a.y < b.y ? b.y : a.y, r};
    const int32_t most = least(box.x1 - box.x0, box.y1 - box.y0) / 2;

    box.r = r < 0 ? 0 : least(r, most);
    return box;
}

/* The interval of a line. */
static struct etch_span span_of(const struct box *box, int32_t y)
{
    const int32_t above = box->y0 + box->r - y, below = y - (box->y1 - box->r);
    const int32_t off = above > 0 ? above : below > 0 ? below : 0;
    const int32_t w = y < box->y0 || y >= box->y1 ? -1 : etch_smooth_half(box->r, off);
    const struct etch_span none = {0, 0}, some = {box->x0 + box->r - w, box->x1 - box->r + w};

    return w < 0 ? none : some;
}

static void inside(void *shape, int32_t y, struct etch_row *row)
{
    const struct etch_span outer = span_of(shape, y);

    etch_row_add(row, outer.x0, outer.x1);
}

static void frame(void *shape, int32_t y, struct etch_row *row)
{
    const struct box *const box = shape; /* outer, inner */
    const struct etch_span outer = span_of(&box[0], y), inner = span_of(&box[1], y);

    if (inner.x0 >= inner.x1) {
        etch_row_add(row, outer.x0, outer.x1);
        return;
    }
    etch_row_add(row, outer.x0, inner.x0);
    etch_row_add(row, inner.x1, outer.x1);
}

static void fill(const struct etch_surface *s, struct box *box, etch_row_function *line,
                 const struct etch_cover_paint *paint, int16_t *cover)
{
    const struct etch_smooth_lines lines = {line, box, box->y0, box->y1};

    etch_smooth_lines_fill(s, &lines, paint, cover);
}

void etch_smooth_round_rect(const struct etch_surface *s, struct etch_point_q8 a,
                            struct etch_point_q8 b, int32_t r, const struct etch_cover_paint *paint,
                            int16_t *cover)
{
    struct box box = box_of(a, b, r);

    fill(s, &box, inside, paint, cover);
}

void etch_smooth_round_frame(const struct etch_surface *s, struct etch_point_q8 a,
                             struct etch_point_q8 b, int32_t r, int32_t width,
                             const struct etch_cover_paint *paint, int16_t *cover)
{
    struct box box[2] = {box_of(a, b, r), box_of(a, b, r)};

    if (width <= 0)
        return;
    box[1].x0 += width, box[1].y0 += width;
    box[1].x1 -= width, box[1].y1 -= width;
    box[1].r = box[1].r < width ? 0 : box[1].r - width;
    fill(s, box, frame, paint, cover);
}
