/* raster/circle.c: the midpoint circle, octant by octant. Called by applications. See circle.h.
 *
 * In the octant 0 <= x <= y the circle's pixels are (x, y(x)) with
 *
 *      (y - 1/2)^2 < r^2 - x^2 < (y + 1/2)^2        never equal: 1/4 is no integer
 *
 * for x up to the last with x <= y(x). y never grows, so a clip rectangle is an interval of x
 * in each octant, found by square roots, and the walk needs no test per pixel.
 */
#include "line.h"
#include "octant.h"

/* ceil(sqrt(v)) and floor(sqrt(v)) for v <= 2^30 + 2^15; v <= 0 gives 0 and -1 below 0. */
static int32_t sqrt_up(int32_t v)
{
    const int32_t root = v > 0 ? etch_sqrt_u32((uint32_t)v) : 0;

    return root * root < v ? root + 1 : root;
}

static int32_t sqrt_down(int32_t v)
{
    return v < 0 ? -1 : (int32_t)etch_sqrt_u32((uint32_t)v);
}

/* One image of the octant: pixel (x, y) goes to (cx + sx x, cy + sy y), or if `swapped` to
 * (cx + sx y, cy + sy x). */
struct octant {
    int8_t sx, sy;
    bool swapped;
    int32_t from, to; /* the x to draw */
};

/* The part lo .. hi of the axis that grows by `sign` from `centre`. */
static void mirror(int8_t sign, int32_t centre, int32_t *lo, int32_t *hi)
{
    const int32_t first = sign > 0 ? *lo - centre : centre - *hi;
    const int32_t last = sign > 0 ? *hi - centre : centre - *lo;

    *lo = first;
    *hi = last;
}

/* Cuts an octant to the clip. */
static void octant_clip(struct octant *o, struct etch_rect clip, int16_t cx, int16_t cy, int32_t r)
{
    int32_t x_lo = o->swapped ? clip.y0 : clip.x0, x_hi = (o->swapped ? clip.y1 : clip.x1) - 1;
    int32_t y_lo = o->swapped ? clip.x0 : clip.y0, y_hi = (o->swapped ? clip.x1 : clip.y1) - 1;

    mirror(o->swapped ? o->sy : o->sx, o->swapped ? cy : cx, &x_lo, &x_hi);
    mirror(o->swapped ? o->sx : o->sy, o->swapped ? cx : cy, &y_lo, &y_hi);
    if (y_hi < 0 || y_lo > r) {
        o->to = -1;
        return;
    }
    if (y_hi < r) { /* y(x) <= y_hi  <=>  x^2 >= r^2 - y_hi^2 - y_hi */
        const int32_t x = sqrt_up(r * r - y_hi * y_hi - y_hi);

        x_lo = x > x_lo ? x : x_lo;
    }
    if (y_lo > 0) { /* y(x) >= y_lo  <=>  x^2 <= r^2 - y_lo^2 + y_lo - 1 */
        const int32_t x = sqrt_down(r * r - y_lo * y_lo + y_lo - 1);

        x_hi = x < x_hi ? x : x_hi;
    }
    o->from = x_lo > o->from ? x_lo : o->from;
    o->to = x_hi < o->to ? x_hi : o->to;
}

/* The outline's y at x; y(0) = y(1) = r. */
static int32_t outline_y(int32_t x, int32_t r)
{
    const int32_t square = r * r - x * x;
    int32_t y;

    if (x <= 1)
        return r;
    y = sqrt_down(square);
    return y + (square - y * y > y); /* nearest */
}

/* Writes x = from .. to of an octant. From one pixel to the next, d = F(x, y - 1/2) - 1/4 with
 * F = x^2 + y^2 - r^2 grows by right = 2 x - 1; if it is not below 0 then, the midpoint is outside,
 * y falls and d shrinks by down = 2 y - 2. |d| <= 2^17 for r <= 32767. Steps before it writes, so
 * that p never leaves the clip. */
static void octant_draw(const struct octant *o, const struct etch_surface *s, int16_t cx,
                        int16_t cy, int32_t r, uint16_t color)
{
    const int32_t from = o->from, y = outline_y(from, r);
    const int16_t px = (int16_t)(cx + o->sx * (o->swapped ? y : from));
    const int16_t py = (int16_t)(cy + o->sy * (o->swapped ? from : y));
    const ptrdiff_t row = o->sy > 0 ? (ptrdiff_t)s->stride : -(ptrdiff_t)s->stride;
    const ptrdiff_t along = o->swapped ? row : o->sx, across = o->swapped ? o->sx : row;
    uint16_t *p = s->pixels + etch_surface_index(s, px, py);
    int32_t right = 2 * from - 1, down = 2 * y - 2;
    int32_t d = from * from + y * y - y - r * r;
    const int32_t last = 2 * o->to - 1;

    *p = color;
    while (right != last) {
        right += 2;
        p += along;
        d += right;
        if (d >= 0) {
            p -= across;
            d -= down;
            down -= 2;
        }
        *p = color;
    }
}

/* Whether no clipping is needed. */
static bool circle_is_inside(const struct etch_rect *c, int16_t cx, int16_t cy, int16_t r)
{
    return cx - (int32_t)r >= c->x0 && cx + (int32_t)r < c->x1 && cy - (int32_t)r >= c->y0 &&
           cy + (int32_t)r < c->y1;
}

void etch_circle_draw(const struct etch_surface *s, int16_t cx, int16_t cy, int16_t r,
                      uint16_t color)
{
    if (r <= 0) {
        if (r == 0)
            etch_point_draw(s, cx, cy, color);
        return;
    }

    const bool inside = circle_is_inside(&s->clip, cx, cy, r);
    const int32_t end = octant_end(r);
    const bool diagonal = (int32_t)r * r <= 2 * end * end + end; /* y(end) = end: one pixel */

    for (uint8_t i = 0; i < 8; i++) {
        struct octant o = {(int8_t)((i & 1) ? -1 : 1), (int8_t)((i & 2) ? -1 : 1), (i & 4) != 0, 0,
                           end};

        if ((o.swapped ? o.sy : o.sx) < 0)
            o.from = 1; /* x = 0 belongs to the other sign */
        if (o.swapped && diagonal)
            o.to = end - 1;
        if (!inside)
            octant_clip(&o, s->clip, cx, cy, r);
        if (o.from <= o.to)
            octant_draw(&o, s, cx, cy, r, color);
    }
}
