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

/* A line in the order in which it is walked, whole. */
struct line {
    struct etch_point from;
    bool steep;     /* u is y */
    bool falls;     /* v falls as u grows; either if it never moves */
    bool backward;  /* from b to a */
    int32_t du, dv; /* as in struct walk, */
    int32_t e, n;   /* and at its beginning */
};

ETCH_INLINE struct line line_of(struct etch_point a, struct etch_point b)
{
    const int32_t dx = (int32_t)b.x - a.x, dy = (int32_t)b.y - a.y;
    const int32_t ax = dx < 0 ? -dx : dx, ay = dy < 0 ? -dy : dy;
    struct line s;

    s.steep = ay > ax;
    s.falls = (dx ^ dy) < 0;
    s.backward = s.steep ? dy < 0 : dx < 0;
    s.from = s.backward ? b : a;
    s.du = s.steep ? ay : ax;
    s.dv = s.steep ? ax : ay;
    s.e = ((s.du - (s.du != 0)) >> 1) - s.du;
    s.n = s.du;
    return s;
}

/* Leaves out b; false if nothing is left. */
ETCH_INLINE bool line_open(struct line *s)
{
    int16_t *const u = s->steep ? &s->from.y : &s->from.x, *const v = s->steep ? &s->from.x
                                                                               : &s->from.y;

    if (s->n-- == 0)
        return false;
    if (s->backward) {
        ++*u;
        s->e += s->dv;
        if (s->e >= 0) {
            s->e -= s->du;
            *v = (int16_t)(s->falls ? *v - 1 : *v + 1);
        }
    }
    return true;
}

/* All of it is inside. */
ETCH_INLINE void line_walk(const struct etch_surface *surface, const struct line *s, uint16_t color)
{
    uint16_t *const pixel = surface->pixels + etch_surface_index(surface, s->from.x, s->from.y);
    const ptrdiff_t row = (ptrdiff_t)surface->stride;
    const ptrdiff_t along = s->steep ? row : 1, side = s->steep ? 1 : row;
    const ptrdiff_t aside = s->falls ? along - side : along + side;

    /* Above 1/2 the roles change: it goes along where dv' = du - dv reaches 0 from e'. */
    if (2 * s->dv <= s->du)
        etch_line_walk(pixel, (uint32_t)s->n, along, aside, s->e, s->du, s->dv, color);
    else
        etch_line_walk(pixel, (uint32_t)s->n, aside, along, -1 - (s->e + s->du), s->du,
                       s->du - s->dv, color);
}

/* What the clip leaves of the line, without b if `open`. */
static ETCH_COLD void line_part(const struct etch_surface *surface, struct etch_point a,
                                struct etch_point b, bool open, uint16_t color)
{
    const struct etch_rect c = surface->clip, turned = {c.y0, c.x0, c.y1, c.x1};
    struct line s = line_of(a, b);
    struct walk w;

    if (open && !line_open(&s))
        return;
    w = (struct walk){.u = s.steep ? s.from.y : s.from.x,
                      .v = s.steep ? s.from.x : s.from.y,
                      .e = s.e,
                      .du = s.du,
                      .dv = s.dv,
                      .sv = s.falls ? -1 : 1,
                      .n = s.n};
    if (!walk_clip(&w, s.steep ? &turned : &c))
        return;
    s.from.x = (int16_t)(s.steep ? w.v : w.u);
    s.from.y = (int16_t)(s.steep ? w.u : w.v);
    s.e = w.e;
    s.n = w.n;
    line_walk(surface, &s, color);
}

ETCH_INLINE bool is_whole(const struct etch_rect *clip, struct etch_point a, struct etch_point b)
{
    return is_inside(clip, a) && is_inside(clip, b);
}

/* The line without b. */
static void segment(const struct etch_surface *s, struct etch_point a, struct etch_point b,
                    uint16_t color)
{
    if (is_whole(&s->clip, a, b)) {
        struct line line = line_of(a, b);

        if (line_open(&line))
            line_walk(s, &line, color);
    } else {
        line_part(s, a, b, true, color);
    }
}

void etch_line_draw(const struct etch_surface *s, int16_t x0, int16_t y0, int16_t x1, int16_t y1,
                    uint16_t color)
{
    const struct etch_point a = {x0, y0}, b = {x1, y1};

    if (is_whole(&s->clip, a, b)) {
        const struct line line = line_of(a, b);

        line_walk(s, &line, color);
    } else {
        line_part(s, a, b, false, color);
    }
}

void etch_polyline_draw(const struct etch_surface *s, const struct etch_point *p, size_t n,
                        uint16_t color)
{
    bool moved = false;

    if (n == 0)
        return;
    for (size_t i = 1; i < n; i++) {
        segment(s, p[i - 1], p[i], color);
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
        segment(s, from, p[i], color);
        moved = moved || from.x != p[i].x || from.y != p[i].y;
        from = p[i];
    }
    if (!moved)
        etch_point_draw(s, from.x, from.y, color);
}
