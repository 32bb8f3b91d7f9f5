/* raster/stroke.c: thick polylines. Called by applications. See stroke.h. */
#include "stroke_parts.h"

static bool is_equal(struct etch_point_q8 a, struct etch_point_q8 b)
{
    return a.x == b.x && a.y == b.y;
}

static struct etch_point_q8 turned(struct etch_point_q8 n)
{
    const struct etch_point_q8 back = {-n.x, -n.y};
    return back;
}

void etch_stroke_outline(const struct etch_outline *o, const struct etch_point_q8 *v, uint16_t n,
                         bool closed, const struct etch_stroke *stroke)
{
    struct etch_point_q8 first = {0, 0}, across = {0, 0};
    bool begun = false;
    uint16_t at = 0; /* the last point taken */

    if (stroke->width_q8 < 2 || stroke->width_q8 > INT32_C(32768) || n == 0)
        return;
    for (uint32_t i = 1; i < (uint32_t)n + (closed ? 1 : 0); i++) {
        const struct etch_point_q8 a = v[at], b = v[i == n ? 0 : i];
        struct etch_point_q8 next;

        if (is_equal(a, b))
            continue;
        next = etch_stroke_scaled(-(b.y - a.y), b.x - a.x, stroke->width_q8 / 2);
        if (begun)
            stroke->join(o, a, across, next, stroke);
        else
            first = next;
        etch_stroke_segment(o, a, b, next);
        across = next;
        begun = true;
        at = (uint16_t)(i == n ? 0 : i);
    }
    if (!begun)
        return;
    if (closed) {
        stroke->join(o, v[0], across, first, stroke);
    } else {
        stroke->cap(o, v[0], turned(first), turned(first), stroke);
        stroke->cap(o, v[at], across, across, stroke);
    }
}
