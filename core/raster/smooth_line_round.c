/* raster/smooth_line_round.c: smooth lines with round ends. Called by applications. See
 * smooth_shapes.h.
 *
 * The shape is convex, so each line has one interval: from the first to the last end of those of
 * the rectangle and of the two discs. */
#include "smooth_line.h"
#include "smooth_lines.h"
#include "smooth_walk.h"

struct capsule {
    struct etch_point_q8 end[2];
    int32_t r, at; /* `at`: the line where the edges are */
    struct etch_smooth smooth;
    struct etch_smooth_edge edge[4];
};

static void widen(struct etch_span *span, int32_t x0, int32_t x1)
{
    span->x0 = x0 < span->x0 ? x0 : span->x0;
    span->x1 = x1 > span->x1 ? x1 : span->x1;
}

static void line(void *shape, int32_t y, struct etch_row *row)
{
    struct capsule *const p = shape;
    const int32_t at = (y - 8) >> 4;
    struct etch_span span = {INT32_MAX, INT32_MIN};

    for (uint8_t i = 0; i < 2; i++) {
        const int32_t w = etch_smooth_half(p->r, y - p->end[i].y);

        if (w >= 0)
            widen(&span, p->end[i].x - w, p->end[i].x + w);
    }
    for (uint16_t i = 0; i < p->smooth.count; i++) {
        struct etch_smooth_edge *const g = &p->edge[i];

        if (at < g->line0 || at >= g->line1)
            continue;
        if (at > g->line0 && at == p->at + 1)
            etch_smooth_edge_step(g);
        else
            etch_smooth_edge_place(g, at);
        widen(&span, g->x, g->x);
    }
    p->at = at;
    etch_row_add(row, span.x0, span.x1);
}

void etch_smooth_line_round(const struct etch_surface *s, struct etch_point_q8 a,
                            struct etch_point_q8 b, int32_t width,
                            const struct etch_cover_paint *paint, int16_t *cover)
{
    struct capsule p = {{a, b}, width / 2, INT32_MIN / 2, {0}, {{0}}};
    const struct etch_smooth_lines lines = {line, &p, (a.y < b.y ? a.y : b.y) - width / 2,
                                            (a.y < b.y ? b.y : a.y) + width / 2};

    if (width < 2 || width > INT32_C(32768))
        return;
    etch_smooth_init(&p.smooth, p.edge, 4);
    etch_smooth_line_edges(&p.smooth, a, b, width);
    etch_smooth_lines_fill(s, &lines, paint, cover);
}
