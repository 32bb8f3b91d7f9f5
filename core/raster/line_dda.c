/* raster/line_dda.c: DDA lines. Called by applications. See line_dda.h.
 *
 * With slope = round(2^16 dv / du) pixel k = 0 .. du lies m(k) = floor((slope k + 2^15 - 1) / 2^16)
 * steps along the minor axis; slope k <= 2^16 * 65535 < 2^32 - 2^15. m never falls, so the clip is
 * an interval of k. */
#include "line_dda.h"

enum {
    HALF = 32767 /* a tie stays */
};

struct walk {
    int32_t a[2]; /* the end with the smaller major coordinate */
    int32_t du;
    uint32_t slope; /* 0 .. 65536 */
};

/* The first k with m(k) >= m, du + 1 if there is none. */
static int32_t reach(const struct walk *w, int32_t m)
{
    uint32_t k;

    if (m <= 0)
        return 0;
    if (w->slope == 0 || m > w->du)
        return w->du + 1;
    k = (((uint32_t)m << 16) - HALF + w->slope - 1) / w->slope;
    return k > (uint32_t)w->du ? w->du + 1 : (int32_t)k;
}

void etch_line_draw_dda(const struct etch_surface *s, int16_t x0, int16_t y0, int16_t x1,
                        int16_t y1, uint16_t color)
{
    const struct etch_rect clip = s->clip;
    const int32_t lo[2] = {clip.x0, clip.y0}, hi[2] = {clip.x1, clip.y1};
    const int32_t d[2] = {(int32_t)x1 - x0, (int32_t)y1 - y0};
    const uint32_t size[2] = {(uint32_t)(d[0] < 0 ? -d[0] : d[0]),
                              (uint32_t)(d[1] < 0 ? -d[1] : d[1])};
    const uint8_t u = size[1] > size[0], v = u ^ 1;
    const bool backward = d[u] < 0, falls = (d[v] < 0) != backward;
    struct walk w = {{backward ? x1 : x0, backward ? y1 : y0}, (int32_t)size[u], 0};

    if (w.du != 0) /* the sum passes 2^32 where dv = du = 65535: 2^16 by name */
        w.slope = size[v] == size[u] ? 65536 : (size[v] * 65536 + size[u] / 2) / size[u];

    const int32_t below = falls ? w.a[v] - hi[v] + 1 : lo[v] - w.a[v];
    int32_t from = reach(&w, below), to = reach(&w, below + hi[v] - lo[v]) - 1;

    if (from < lo[u] - w.a[u])
        from = lo[u] - w.a[u];
    if (to > hi[u] - 1 - w.a[u])
        to = hi[u] - 1 - w.a[u];
    if (from > to)
        return;

    const ptrdiff_t step[2] = {1, (ptrdiff_t)s->stride};
    const ptrdiff_t aside = falls ? -step[v] : step[v];
    uint32_t at = w.slope * (uint32_t)from + HALF;
    const int32_t m = (int32_t)(at >> 16);
    int32_t p[2];

    p[u] = w.a[u] + from;
    p[v] = falls ? w.a[v] - m : w.a[v] + m;
    uint16_t *pixel = s->pixels + etch_surface_index(s, (int16_t)p[0], (int16_t)p[1]);

    at &= 0xFFFF; /* the fraction; its carry is a step aside */
    for (;;) {
        *pixel = color;
        if (from++ == to)
            return;
        at += w.slope;
        pixel += step[u] + (at >> 16 != 0 ? aside : 0);
        at &= 0xFFFF;
    }
}
