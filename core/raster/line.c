/* raster/line.c: clipped Bresenham lines. Called by applications and by draw/. See line.h.
 *
 * u is the major axis, walked upwards, v the minor one. With du >= dv >= 0 and k = 0 .. du the
 * pixel k lies m(k) steps along v:
 *
 *      m(k) = floor((dv k + h) / du),  h = (du - 1) / 2
 *
 * the nearest pixel, staying on a tie. m never falls, so the clip is an interval of k, found by
 * two divisions; dv k + h <= 65535 * 65535 + 32767 < 2^32.
 */
#include "line.h"
#include "line_walk.h"

/* A line in walking order, and the part of it to draw. */
struct walk {
    int16_t u0, v0; /* the end with the smaller u */
    uint16_t du, dv;
    int8_t sv;         /* v grows or falls */
    uint16_t from, to; /* first and last k */
};

/* Cuts the walk to u_lo .. u_hi - 1 and v_lo .. v_hi - 1; false if nothing is left. */
static bool walk_clip(struct walk *w, int16_t u_lo, int16_t u_hi, int16_t v_lo, int16_t v_hi)
{
    const uint32_t h = (uint32_t)(w->du - (w->du != 0)) / 2;
    const int32_t below = w->sv > 0 ? (int32_t)v_lo - w->v0 : (int32_t)w->v0 - (v_hi - 1);
    const int32_t above = w->sv > 0 ? (int32_t)v_hi - 1 - w->v0 : (int32_t)w->v0 - v_lo;
    int32_t from = w->from, to = w->to;

    if (from < (int32_t)u_lo - w->u0)
        from = (int32_t)u_lo - w->u0;
    if (to > (int32_t)u_hi - 1 - w->u0)
        to = (int32_t)u_hi - 1 - w->u0;
    if (above < 0 || below > (int32_t)w->dv || above < below || from > to)
        return false;
    if (below > 0) { /* m(k) >= below  <=>  dv k >= below du - h */
        const uint32_t k = ((uint32_t)below * w->du - h + w->dv - 1) / w->dv;

        if (from < (int32_t)k)
            from = (int32_t)k;
    }
    if (above < (int32_t)w->dv) { /* m(k) <= above  <=>  dv k < (above + 1) du - h */
        const uint32_t k = ((uint32_t)(above + 1) * w->du - h - 1) / w->dv;

        if (to > (int32_t)k)
            to = (int32_t)k;
    }
    if (from > to)
        return false;
    w->from = (uint16_t)from;
    w->to = (uint16_t)to;
    return true;
}

static bool is_inside(const struct etch_rect *c, struct etch_point p)
{
    return p.x >= c->x0 && p.x < c->x1 && p.y >= c->y0 && p.y < c->y1;
}

/* The line without its far end if `open`. */
static void line(const struct etch_surface *s, struct etch_point a, struct etch_point b, bool open,
                 uint16_t color)
{
    const int32_t dx = (int32_t)b.x - a.x, dy = (int32_t)b.y - a.y;
    const bool steep = (dy < 0 ? -dy : dy) > (dx < 0 ? -dx : dx);
    const bool backward = steep ? dy < 0 : dx < 0;
    const struct etch_point p = backward ? b : a;
    const int32_t du = steep ? dy : dx, dv = steep ? dx : dy;
    struct walk w = {
        steep ? p.y : p.x,
        steep ? p.x : p.y,
        (uint16_t)(du < 0 ? -du : du),
        (uint16_t)(dv < 0 ? -dv : dv),
        (int8_t)((dv < 0) == backward ? 1 : -1),
        (uint16_t)(open && backward),
        0,
    };
    const struct etch_rect c = s->clip;

    if (open && du == 0)
        return;
    w.to = (uint16_t)(w.du - (open && !backward));
    if (!(is_inside(&c, a) && is_inside(&c, b)) &&
        !(steep ? walk_clip(&w, c.y0, c.y1, c.x0, c.x1) : walk_clip(&w, c.x0, c.x1, c.y0, c.y1)))
        return;

    const uint32_t h = (uint32_t)(w.du - (w.du != 0)) / 2;
    const uint32_t at = etch_mul_u16(w.dv, w.from) + h;
    const uint32_t m = w.du != 0 && w.from != 0 ? at / w.du : 0;
    const int16_t u = (int16_t)((int32_t)w.u0 + w.from);
    const int16_t v = (int16_t)(w.sv > 0 ? w.v0 + (int32_t)m : w.v0 - (int32_t)m);
    uint16_t *const pixel = s->pixels +
                            (steep ? etch_surface_index(s, v, u) : etch_surface_index(s, u, v));
    const ptrdiff_t row = (ptrdiff_t)s->stride;
    const ptrdiff_t along = steep ? row : 1;
    const ptrdiff_t aside = along + (steep ? w.sv : w.sv > 0 ? row : -row);
    const int32_t e = (int32_t)(at - m * w.du) - w.du; /* dv from + h modulo du, less du */

    /* Above 1/2 the roles change: it goes along where dv' = du - dv reaches 0 from e'. */
    if (2 * (int32_t)w.dv <= w.du)
        etch_line_walk(pixel, (uint32_t)(w.to - w.from), along, aside, e, w.du, w.dv, color);
    else
        etch_line_walk(pixel, (uint32_t)(w.to - w.from), aside, along, -1 - (e + w.du), w.du,
                       w.du - w.dv, color);
}

void etch_line_draw(const struct etch_surface *s, int16_t x0, int16_t y0, int16_t x1, int16_t y1,
                    uint16_t color)
{
    const struct etch_point a = {x0, y0}, b = {x1, y1};

    line(s, a, b, false, color);
}

void etch_polyline_draw(const struct etch_surface *s, const struct etch_point *p, size_t n,
                        uint16_t color)
{
    bool moved = false;

    if (n == 0)
        return;
    for (size_t i = 1; i < n; i++) {
        line(s, p[i - 1], p[i], true, color);
        moved = moved || p[i - 1].x != p[i].x || p[i - 1].y != p[i].y;
    }
    if (!moved || p[0].x != p[n - 1].x || p[0].y != p[n - 1].y)
        etch_point_draw(s, p[n - 1].x, p[n - 1].y, color);
}

void etch_polygon_draw(const struct etch_surface *s, const struct etch_point *p, size_t n,
                       uint16_t color)
{
    bool moved = false;

    for (size_t i = 0; i < n; i++) {
        const struct etch_point to = p[i + 1 == n ? 0 : i + 1];

        line(s, p[i], to, true, color);
        moved = moved || p[i].x != to.x || p[i].y != to.y;
    }
    if (n > 0 && !moved)
        etch_point_draw(s, p[0].x, p[0].y, color);
}
