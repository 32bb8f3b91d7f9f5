/* raster/line_small.c: clipped Bresenham lines in few bytes. Called by applications. See line.h for
 * the contract and line.c for the derivation: u is the major axis, walked upwards, v the minor
 * one, and pixel k = 0 .. du lies m(k) = floor((dv k + h) / du) steps along v. Coordinates stand
 * in pairs here, so that an axis is an index. */
#include "line_small.h"

/* n / d by shift and subtract; d is 1 .. 65535. */
static uint32_t divide(uint32_t n, uint32_t d, uint32_t *rest)
{
    uint32_t r = 0;

    for (uint8_t bit = 32; bit != 0; bit--) { /* n gives its bits and takes the quotient's */
        r = r << 1 | n >> 31;
        n = etch_wrap_add(n, n);
        if (r >= d)
            r -= d, n |= 1;
    }
    *rest = r;
    return n;
}

struct walk {
    int32_t du, dv, h;
};

/* The first k with m(k) >= m, du + 1 if there is none: dv k + h >= m du. */
static int32_t reach(const struct walk *w, int32_t m)
{
    uint32_t rest;

    if (m <= 0)
        return 0;
    if (m > w->dv)
        return w->du + 1;
    return (int32_t)divide((uint32_t)m * (uint32_t)w->du - (uint32_t)w->h + (uint32_t)w->dv - 1,
                           (uint32_t)w->dv, &rest);
}

void etch_line_draw_small(const struct etch_surface *s, int16_t x0, int16_t y0, int16_t x1,
                          int16_t y1, uint16_t color)
{
    const struct etch_rect clip = s->clip;
    const int32_t lo[2] = {clip.x0, clip.y0}, hi[2] = {clip.x1, clip.y1};
    const ptrdiff_t step[2] = {1, (ptrdiff_t)s->stride};
    int32_t a[2] = {x0, y0}, d[2] = {x1 - (int32_t)x0, y1 - (int32_t)y0};
    const uint8_t u = (d[1] < 0 ? -d[1] : d[1]) > (d[0] < 0 ? -d[0] : d[0]), v = u ^ 1;
    struct walk w;

    if (d[u] < 0) {
        a[0] = x1, a[1] = y1;
        d[0] = -d[0], d[1] = -d[1];
    }
    const bool falls = d[v] < 0;

    w.du = d[u];
    w.dv = falls ? -d[v] : d[v];
    w.h = (w.du - (w.du != 0)) / 2;

    /* the steps along v that stay inside the clip, then the k that do */
    const int32_t below = falls ? a[v] - hi[v] + 1 : lo[v] - a[v];
    int32_t from = reach(&w, below), to = reach(&w, below + hi[v] - lo[v]) - 1;

    if (from < lo[u] - a[u])
        from = lo[u] - a[u];
    if (to > hi[u] - 1 - a[u])
        to = hi[u] - 1 - a[u];
    if (from > to)
        return;

    uint32_t rest = 0;
    const uint32_t m = w.du == 0 ? 0
                                 : divide((uint32_t)w.dv * (uint32_t)from + (uint32_t)w.h,
                                          (uint32_t)w.du, &rest);
    a[u] += from;
    a[v] += falls ? -(int32_t)m : (int32_t)m;
    uint16_t *pixel = s->pixels + etch_surface_index(s, (int16_t)a[0], (int16_t)a[1]);
    const ptrdiff_t along = step[u], across = falls ? -step[v] : step[v];
    int32_t e = (int32_t)rest - w.du;

    for (;;) {
        *pixel = color;
        if (from++ == to)
            return;
        pixel += along;
        e += w.dv;
        if (e >= 0)
            e -= w.du, pixel += across;
    }
}
