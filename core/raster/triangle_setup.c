/* raster/triangle_setup.c: sorting and measuring, the first part of triangle set-up. Called by
 * draw/. See triangle.h. */
#include "triangle.h"

static bool is_above(const struct etch_point_q8 *a, const struct etch_point_q8 *b)
{
    return a->y < b->y || (a->y == b->y && a->x < b->x);
}

/* The first column or row whose centre is at or beyond c. */
static int32_t first_centre(int32_t c_q8)
{
    return (c_q8 + 127) >> 8;
}

static void columns(struct etch_triangle *t)
{
    const int32_t ax = t->p[0].x, bx = t->p[1].x, cx = t->p[2].x;
    int32_t least = ax < bx ? ax : bx, most = ax < bx ? bx : ax;

    least = cx < least ? cx : least;
    most = cx > most ? cx : most;
    t->x0 = first_centre(least);
    t->x1 = first_centre(most);
}

/* Area and side: of p[1] against the edge p[0] p[2]. */
static bool measure(struct etch_triangle *t, int8_t winding)
{
    const int32_t x1 = t->p[1].x - t->p[0].x, y1 = t->p[1].y - t->p[0].y;
    const int32_t x2 = t->p[2].x - t->p[0].x, y2 = t->p[2].y - t->p[0].y;
    bool right;

    if (t->x1 - t->x0 < 127 && t->y1 - t->y0 < 127) { /* products below 2^30 */
        const int32_t area = x1 * y2 - x2 * y1;

        right = area > 0;
        t->area = right ? (uint32_t)area : (uint32_t)-area;
    } else {
        const int64_t area = etch_mul_s32(x1, y2) - etch_mul_s32(x2, y1);

        right = area > 0;
        t->area = right ? (uint64_t)area : (uint64_t)-area;
    }
    t->side = right ? 1 : -1;
    t->winding = right ? winding : (int8_t)-winding;
    return t->area != 0;
}

bool etch_triangle_setup(struct etch_triangle *t, const struct etch_point_q8 v[3])
{
    const struct etch_point_q8 *a = v, *b = v + 1, *c = v + 2, *other;
    int8_t winding = 1;

    if (is_above(b, a))
        other = a, a = b, b = other, winding = -1;
    if (is_above(c, b)) {
        other = b, b = c, c = other, winding = (int8_t)-winding;
        if (is_above(b, a))
            other = a, a = b, b = other, winding = (int8_t)-winding;
    }
    t->p[0] = *a, t->p[1] = *b, t->p[2] = *c;
    t->order[0] = (uint8_t)(a - v);
    t->order[1] = (uint8_t)(b - v);
    t->order[2] = (uint8_t)(c - v);
    t->y0 = first_centre(a->y);
    t->y1 = first_centre(c->y);
    columns(t);

    return measure(t, winding);
}
