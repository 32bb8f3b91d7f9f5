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

/* A line in walking order: where it begins, and what is left of it. */
struct walk {
    int32_t u, v;   /* the first pixel left */
    int32_t e;      /* there, dv k + h modulo du, less du */
    int32_t du, dv; /* of the whole line */
    int32_t sv;     /* v grows or falls, 1 or -1 */
    int32_t n;      /* pixels left after the first */
};

/* Leaves out the first pixel. */
ETCH_INLINE void walk_step(struct walk *w)
{
    w->u++;
    w->e += w->dv;
    if (w->e >= 0)
        w->e -= w->du, w->v += w->sv;
}

/* Leaves out the first k pixels. */
static ETCH_COLD void walk_skip(struct walk *w, uint32_t k)
{
    const uint32_t at = (uint32_t)w->dv * k + (uint32_t)(w->e + w->du);
    const uint32_t m = at / (uint32_t)w->du;

    w->u += (int32_t)k;
    w->v += w->sv * (int32_t)m;
    w->e = (int32_t)(at - m * (uint32_t)w->du) - w->du;
    w->n -= (int32_t)k;
}

/* Cuts a walk to the columns u and rows v of the clip; false if nothing is left. */
static ETCH_COLD bool walk_clip(struct walk *w, const struct etch_rect *clip)
{
    const uint32_t h = (uint32_t)(w->e + w->du), du = (uint32_t)w->du, dv = (uint32_t)w->dv;
    const int32_t below = w->sv > 0 ? clip->y0 - w->v : w->v - (clip->y1 - 1);
    const int32_t above = w->sv > 0 ? clip->y1 - 1 - w->v : w->v - clip->y0;
    int32_t from = w->u < clip->x0 ? clip->x0 - w->u : 0;
    int32_t to = w->u + w->n < clip->x1 ? w->n : clip->x1 - 1 - w->u;

    if (above < 0 || below > w->dv || above < below || from > to)
        return false;
    if (below > 0) { /* m(k) >= below  <=>  dv k >= below du - h */
        const int32_t k = (int32_t)(((uint32_t)below * du - h + dv - 1) / dv);

        from = from < k ? k : from;
    }
    if (above < w->dv) { /* m(k) <= above  <=>  dv k < (above + 1) du - h */
        const int32_t k = (int32_t)(((uint32_t)(above + 1) * du - h - 1) / dv);

        to = to > k ? k : to;
    }
    if (from > to)
        return false;
    w->n = to;
    if (from > 0)
        walk_skip(w, (uint32_t)from);
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
    const int32_t ax = dx < 0 ? -dx : dx, ay = dy < 0 ? -dy : dy;
    const bool steep = ay > ax, backward = steep ? dy < 0 : dx < 0;
    const struct etch_point p = backward ? b : a;
    struct walk w;

    w.u = steep ? p.y : p.x;
    w.v = steep ? p.x : p.y;
    w.du = steep ? ay : ax;
    w.dv = steep ? ax : ay;
    w.sv = ((steep ? dx : dy) < 0) == backward ? 1 : -1;
    w.n = w.du;
    w.e = ((w.du - (w.du != 0)) >> 1) - w.du;
    if (open) {
        if (w.n-- == 0)
            return;
        if (backward)
            walk_step(&w);
    }
    if (!is_inside(&s->clip, a) || !is_inside(&s->clip, b)) {
        const struct etch_rect c = s->clip, turned = {c.y0, c.x0, c.y1, c.x1};
        struct walk cut = w;

        if (!walk_clip(&cut, steep ? &turned : &c))
            return;
        w = cut;
    }
    uint16_t *const pixel = s->pixels + (steep ? etch_surface_index(s, (int16_t)w.v, (int16_t)w.u)
                                               : etch_surface_index(s, (int16_t)w.u, (int16_t)w.v));
    const ptrdiff_t row = (ptrdiff_t)s->stride;
    const ptrdiff_t along = steep ? row : 1;
    const ptrdiff_t aside = along + (steep ? (ptrdiff_t)w.sv : w.sv > 0 ? row : -row);

    /* Above 1/2 the roles change: it goes along where dv' = du - dv reaches 0 from e'. */
    if (2 * w.dv <= w.du)
        etch_line_walk(pixel, (uint32_t)w.n, along, aside, w.e, w.du, w.dv, color);
    else
        etch_line_walk(pixel, (uint32_t)w.n, aside, along, -1 - (w.e + w.du), w.du, w.du - w.dv,
                       color);
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
    struct etch_point from;

    if (n == 0)
        return;
    from = p[n - 1];
    for (size_t i = 0; i < n; i++) {
        line(s, from, p[i], true, color);
        moved = moved || from.x != p[i].x || from.y != p[i].y;
        from = p[i];
    }
    if (!moved)
        etch_point_draw(s, from.x, from.y, color);
}
