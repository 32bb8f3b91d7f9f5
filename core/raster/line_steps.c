/* raster/line_steps.c: which pixels of a line are inside a clip. Called by line_runs.c and by the
 * painters of lines. See line_steps.h. */
#include "line_steps.h"

/* The first k with m(k) >= m, du + 1 if there is none: dv k + h >= m du. */
static int32_t reach(const struct etch_line_steps *s, int32_t m)
{
    const uint32_t h = (uint32_t)(s->du - (s->du != 0)) / 2;

    if (m <= 0)
        return 0;
    if (m > s->dv)
        return s->du + 1;
    return (int32_t)(((uint32_t)m * (uint32_t)s->du - h + (uint32_t)s->dv - 1) / (uint32_t)s->dv);
}

bool etch_line_steps_setup(struct etch_line_steps *s, const struct etch_rect *clip, int16_t x0,
                           int16_t y0, int16_t x1, int16_t y1)
{
    const int32_t lo[2] = {clip->x0, clip->y0}, hi[2] = {clip->x1, clip->y1};
    const int32_t d[2] = {(int32_t)x1 - x0, (int32_t)y1 - y0};
    const uint8_t u = (d[1] < 0 ? -d[1] : d[1]) > (d[0] < 0 ? -d[0] : d[0]), v = u ^ 1;
    const bool backward = d[u] < 0;

    s->a[0] = backward ? x1 : x0;
    s->a[1] = backward ? y1 : y0;
    s->u = u;
    s->falls = (d[v] < 0) != backward && d[v] != 0;
    s->du = backward ? -d[u] : d[u];
    s->dv = d[v] < 0 ? -d[v] : d[v];

    /* the steps along v that stay inside the clip, then the k that do */
    const int32_t below = s->falls ? s->a[v] - hi[v] + 1 : lo[v] - s->a[v];

    s->from = reach(s, below);
    s->to = reach(s, below + hi[v] - lo[v]) - 1;
    if (s->from < lo[u] - s->a[u])
        s->from = lo[u] - s->a[u];
    if (s->to > hi[u] - 1 - s->a[u])
        s->to = hi[u] - 1 - s->a[u];
    return s->from <= s->to;
}
