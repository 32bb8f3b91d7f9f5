/* raster/triangle.c: triangles to runs. Called by draw/ with a paint. See triangle.h, and edge.h
 * for how an edge is walked. Each edge is walked alone, into the x0 or x1 of a block of runs: its
 * loop then has seven values, which is what ARMv6-M has registers for. */
#include "edge.h"

/* k remainder / dy; k <= 2^16, so the product is below 2^40. */
static ETCH_COLD uint32_t far_down(const struct edge *g, uint32_t k, uint32_t *rest)
{
    const struct etch_quotient r = etch_divide_u64((uint64_t)k * (uint32_t)g->remainder,
                                                   (uint64_t)g->dy);

    *rest = (uint32_t)r.remainder;
    return (uint32_t)r.quotient;
}

/* Moves an edge k rows down at once. Triangles that cross the edge of a strip begin so. */
static void edge_skip(struct edge *g, uint32_t k)
{
    const bool near = k < 256; /* remainder < dy <= 2^24 */
    uint32_t rest;
    const uint32_t more = near ? quotient_of(k * (uint32_t)g->remainder, (uint32_t)g->dy, &rest)
                               : far_down(g, k, &rest);

    g->x += (int32_t)k * g->quotient + (int32_t)more;
    g->e -= (int32_t)rest;
    if (g->e < 0)
        g->e += g->dy, g->x++;
}

/* The same with x held to lo .. hi. */
static int16_t *edge_walk_clipped(struct edge *g, int16_t *out, int32_t n,
                                  const struct etch_rect *clip)
{
    const int32_t lo = clip->x0, hi = clip->x1;

    for (; n > 0; n--, out += 2) {
        const int32_t x = g->x < lo ? lo : g->x;

        *out = (int16_t)(x > hi ? hi : x);
        g->x += g->quotient;
        g->e -= g->remainder;
        if (g->e < 0)
            g->e += g->dy, g->x++;
    }
    return out;
}

/* A triangle inside the clip, of one block of rows. */
static void runs_short(const struct etch_triangle *t, struct etch_run *runs)
{
    int16_t *const far = t->side > 0 ? &runs->x0 : &runs->x1;
    int16_t *near = t->side > 0 ? &runs->x1 : &runs->x0;
    const int32_t bend = (t->p[1].y + 127) >> 8;

    etch_edge_run(t->p[0], t->p[2], far, t->y1 - t->y0);
    if (bend > t->y0)
        near = etch_edge_run(t->p[0], t->p[1], near, bend - t->y0);
    if (bend < t->y1)
        etch_edge_run(t->p[1], t->p[2], near, t->y1 - bend);
}

/* Puts the edge a, b on its row `down`, counted from its first. */
static void edge_at(struct edge *g, const struct etch_point_q8 *a, const struct etch_point_q8 *b,
                    int32_t down)
{
    edge_start(g, *a, *b, true);
    if (down > 0)
        edge_skip(g, (uint32_t)down);
}

static int16_t *walk(struct edge *g, int16_t *out, int32_t n, const struct etch_rect *clip)
{
    return clip == NULL ? edge_walk(g, out, n) : edge_walk_clipped(g, out, n, clip);
}

/* Any triangle, in the rows y .. y1 - 1. `clip` NULL: its columns are inside. */
static void runs_tall(const struct etch_surface *surface, const struct etch_triangle *t,
                      const struct etch_paint *paint, int32_t y, int32_t y1,
                      const struct etch_rect *clip)
{
    const struct etch_point_q8 *const p = t->p;
    const int32_t bend = (p[1].y + 127) >> 8;
    const int32_t lower = bend > y ? bend : y; /* where p[1] p[2] starts */
    struct etch_run runs[ETCH_RUN_BLOCK];
    struct edge whole, part; /* p[0] p[2]; p[0] p[1] and later p[1] p[2] */

    edge_at(&whole, &p[0], &p[2], y - t->y0);
    if (y < lower)
        edge_at(&part, &p[0], &p[1], y - t->y0);
    do {
        const int32_t n = y1 - y < ETCH_RUN_BLOCK ? y1 - y : ETCH_RUN_BLOCK;
        int32_t rest = y + n - lower; /* rows of the lower edge in this block */
        int16_t *out = t->side > 0 ? &runs[0].x1 : &runs[0].x0;

        walk(&whole, t->side > 0 ? &runs[0].x0 : &runs[0].x1, n, clip);
        rest = rest < 0 ? 0 : rest < n ? rest : n;
        if (rest < n)
            out = walk(&part, out, n - rest, clip);
        if (rest > 0) {
            if (y + n - rest == lower)
                edge_at(&part, &p[1], &p[2], lower - bend);
            walk(&part, out, rest, clip);
        }
        paint->kernel(surface, (int16_t)y, runs, (uint8_t)n, paint);
        y += n;
    } while (y < y1);
}

void etch_triangle_runs(const struct etch_surface *surface, const struct etch_triangle *t,
                        const struct etch_paint *paint)
{
    const struct etch_rect *const clip = &surface->clip;
    const bool inside = t->x0 >= clip->x0 && t->x1 <= clip->x1;

    if (inside && t->y0 >= clip->y0 && t->y1 <= clip->y1 && t->y1 - t->y0 <= ETCH_RUN_BLOCK) {
        struct etch_run runs[ETCH_RUN_BLOCK];

        if (t->y0 == t->y1)
            return;
        runs_short(t, runs);
        paint->kernel(surface, (int16_t)t->y0, runs, (uint8_t)(t->y1 - t->y0), paint);
    } else {
        const int32_t y = t->y0 > clip->y0 ? t->y0 : clip->y0;
        const int32_t y1 = t->y1 < clip->y1 ? t->y1 : clip->y1;

        if (y < y1 && t->x0 < clip->x1 && t->x1 > clip->x0)
            runs_tall(surface, t, paint, y, y1, inside ? NULL : clip);
    }
}
