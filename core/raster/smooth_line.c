/* raster/smooth_line.c: smooth lines with square ends. Called by applications and
 * smooth_line_round.c. See smooth_shapes.h. */
#include "smooth_line.h"
#include "stroke_parts.h"

void etch_smooth_line_edges(struct etch_smooth *to, struct etch_point_q8 a, struct etch_point_q8 b,
                            int32_t width)
{
    const struct etch_outline o = {etch_outline_smooth, to};

    if (width >= 2 && width <= INT32_C(32768) && (a.x != b.x || a.y != b.y))
        etch_stroke_segment(&o, a, b, etch_stroke_scaled(-(b.y - a.y), b.x - a.x, width / 2));
}

void etch_smooth_line(const struct etch_surface *s, struct etch_point_q8 a, struct etch_point_q8 b,
                      int32_t width, const struct etch_cover_paint *paint, int16_t *cover)
{
    struct etch_smooth_edge edge[4];
    struct etch_smooth p;

    etch_smooth_init(&p, edge, 4);
    etch_smooth_window(&p, s);
    etch_smooth_line_edges(&p, a, b, width);
    etch_smooth_fill_nonzero(s, &p, paint, cover);
}
