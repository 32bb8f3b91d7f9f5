/* raster/triangle.c: the edge walk, triangles to runs. Called by draw/ with a paint.
 *
 * An edge from (xa, ya) down to (xb, yb) in 1/256 px crosses the row of centres y_c = 256 y + 128
 * at x_c = xa + (y_c - ya) dx / dy, and the first pixel whose centre is at or right of it is
 *
 *      x = ceil((x_c - 128) / 256) = ceil(M / dy),   M = ceil(((xa - 128) dy + (y_c - ya) dx) / 256)
 *
 * A row further down M grows by exactly dx. So x and e = x dy - M, 0 <= e < dy, step by the
 * quotient and remainder of dx / dy: no rounding, no division, and two triangles that share an
 * edge share its x. The left edge's x is the first pixel inside, the right edge's the first
 * outside: the top-left rule without a case. dy and |dx| are at most 2^24, so all is 32-bit.
 *
 * Each edge is walked alone, into the x0 or x1 of a block of runs: its loop then has seven
 * values, which is what ARMv6-M has registers for.
 */
#include "triangle.h"

struct edge {
    int32_t x, e;                /* of the next row; 0 <= e < dy */
    int32_t dy;                  /* 1 .. 2^24 */
    int32_t quotient, remainder; /* of dx / dy, remainder 0 .. dy - 1 */
};

/* Moves an edge k rows down at once. k <= 2^16, so k * remainder < 2^40. */
static ETCH_COLD void edge_skip(struct edge *g, uint32_t k)
{
    const uint64_t down = (uint64_t)k * (uint32_t)g->remainder;
    const struct etch_quotient r = etch_divide_u64(down, (uint64_t)g->dy);

    g->x += (int32_t)k * g->quotient + (int32_t)r.quotient;
    g->e -= (int32_t)r.remainder;
    if (g->e < 0)
        g->e += g->dy, g->x++;
}

/* ceil((f dy + k rest) / 256) for tall edges, in halves so that nothing passes 2^26. */
static ETCH_COLD int32_t first_offset(int32_t f, int32_t k, int32_t dy, int32_t rest)
{
    return f * (dy >> 8) + k * (rest >> 8) + ((f * (dy & 255) + k * (rest & 255) + 255) >> 8);
}

/* Puts the edge a, b on its first row: with k = 0 .. 255 from a down to that row's centres, and
 * dx = q dy + r, M / dy = (xa - 128 + k q) / 256 + k r / (256 dy). The first term's whole pixels
 * are x; its fraction f leaves less than 2 dy, so ceil(M / dy) adds at most 2. */
ETCH_INLINE void edge_start(struct edge *g, const struct etch_point_q8 *a,
                            const struct etch_point_q8 *b)
{
    const int32_t dy = b->y - a->y;
    const int32_t k = (128 - a->y) & 255;
    int32_t quotient = 0, rest = b->x - a->x;

    if (rest < 0)
        rest += dy, quotient = -1;
    if ((uint32_t)rest >= (uint32_t)dy) { /* flatter than 45 degrees */
        const int32_t more = rest < 0 ? -((dy - 1 - rest) / dy) : rest / dy;

        quotient += more;
        rest -= more * dy;
    }

    const int32_t x_q8 = a->x - 128 + k * quotient;
    const int32_t f = x_q8 & 255;
    int32_t x = x_q8 >> 8;
    int32_t e = dy < INT32_C(1) << 22 ? -((f * dy + k * rest + 255) >> 8)
                                      : -first_offset(f, k, dy, rest);

    if (e < 0)
        e += dy, x++;
    if (e < 0)
        e += dy, x++;
    g->x = x;
    g->e = e;
    g->dy = dy;
    g->quotient = quotient;
    g->remainder = rest;
}

/* Writes x to *out and goes a row down. */
ETCH_INLINE void edge_step(struct edge *g, int16_t *out)
{
    *out = (int16_t)g->x;
    g->x += g->quotient;
    g->e -= g->remainder;
    if (g->e < 0)
        g->e += g->dy, g->x++;
}

/* Writes the edge's x of the next n >= 1 rows to out[0], out[2], ..; returns the next. */
ETCH_INLINE int16_t *edge_walk(struct edge *edge, int16_t *out, int32_t n)
{
    int16_t *const end = out + 2 * n;
    struct edge g = *edge;

    if ((n & 1) != 0) {
        edge_step(&g, out);
        out += 2;
    }
    for (; out != end; out += 4) {
        edge_step(&g, &out[0]);
        edge_step(&g, &out[2]);
    }
    edge->x = g.x;
    edge->e = g.e;
    return out;
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

/* A whole edge of a triangle inside the clip. */
static int16_t *edge_run(const struct etch_point_q8 *a, const struct etch_point_q8 *b, int16_t *out,
                         int32_t n)
{
    struct edge g;

    if (n == 0)
        return out;
    edge_start(&g, a, b);
    return edge_walk(&g, out, n);
}

/* A triangle inside the clip, of one block of rows. */
static void runs_short(const struct etch_triangle *t, struct etch_run *runs)
{
    int16_t *const far = t->side > 0 ? &runs->x0 : &runs->x1;
    int16_t *const near = t->side > 0 ? &runs->x1 : &runs->x0;
    const int32_t bend = (t->p[1].y + 127) >> 8;

    edge_run(&t->p[0], &t->p[2], far, t->y1 - t->y0);
    edge_run(&t->p[1], &t->p[2], edge_run(&t->p[0], &t->p[1], near, bend - t->y0), t->y1 - bend);
}

/* Puts the edge a, b on its row `down`, counted from its first. */
static void edge_at(struct edge *g, const struct etch_point_q8 *a, const struct etch_point_q8 *b,
                    int32_t down)
{
    edge_start(g, a, b);
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
