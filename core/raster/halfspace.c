/* raster/halfspace.c: triangles to runs by edge functions. Called with a paint by whoever wants to
 * compare. See halfspace.h.
 *
 * Clockwise as seen, y down, the edge from a to b has every point p of the triangle at its right:
 *
 *      E(p) = (b_x - a_x) (p_y - a_y) - (b_y - a_y) (p_x - a_x) >= 0
 *
 * less 1 where the edge is neither a top nor a left one, so that E = 0 is outside there. From one
 * pixel to the next E changes by multiples of 256, so floor(E / 256) has its sign and changes by
 * the vertices' differences: at most 2^49 / 2^8 = 2^41 in the box, and 2^24 a step. */
#include "halfspace.h"

struct edge {
    int64_t at;     /* floor(E / 256) at the row's first pixel */
    int32_t dx, dy; /* a pixel to the right, a row down */
};

static struct edge edge(const struct etch_point_q8 *a, const struct etch_point_q8 *b, int32_t x,
                        int32_t y)
{
    const int32_t dx = b->x - a->x, dy = b->y - a->y;
    const bool top_left = dy < 0 || (dy == 0 && dx > 0);
    const int64_t e = etch_mul_s32(dx, 256 * y + 128 - a->y) -
                      etch_mul_s32(dy, 256 * x + 128 - a->x) - (top_left ? 0 : 1);
    const struct edge g = {e >> 8, -dy, dx};

    return g;
}

/* The run of a row: columns x .. x1 - 1 are tested until it has ended. */
static struct etch_run row(const struct edge g[3], int32_t x, int32_t x1)
{
    int64_t a = g[0].at, b = g[1].at, c = g[2].at;
    struct etch_run run;

    for (; x < x1 && (a | b | c) < 0; x++)
        a += g[0].dx, b += g[1].dx, c += g[2].dx;
    run.x0 = (int16_t)x;
    for (; x < x1 && (a | b | c) >= 0; x++)
        a += g[0].dx, b += g[1].dx, c += g[2].dx;
    run.x1 = (int16_t)x;
    return run;
}

void etch_triangle_runs_halfspace(const struct etch_surface *surface, const struct etch_triangle *t,
                                  const struct etch_paint *paint)
{
    const struct etch_rect *const clip = &surface->clip;
    const int32_t x0 = t->x0 > clip->x0 ? t->x0 : clip->x0;
    const int32_t x1 = t->x1 < clip->x1 ? t->x1 : clip->x1;
    const int32_t y1 = t->y1 < clip->y1 ? t->y1 : clip->y1;
    int32_t y = t->y0 > clip->y0 ? t->y0 : clip->y0;
    const struct etch_point_q8 *const p = t->p;
    const bool right = t->side > 0; /* p[0] p[1] p[2] runs clockwise */
    struct etch_run runs[ETCH_RUN_BLOCK];

    if (x0 >= x1 || y >= y1)
        return;
    struct edge g[3] = {edge(&p[0], right ? &p[1] : &p[2], x0, y),
                        edge(right ? &p[1] : &p[2], right ? &p[2] : &p[1], x0, y),
                        edge(right ? &p[2] : &p[1], &p[0], x0, y)};

    while (y < y1) {
        uint8_t n = 0;
        const int16_t first = (int16_t)y;

        for (; y < y1 && n < ETCH_RUN_BLOCK; y++, n++) {
            runs[n] = row(g, x0, x1);
            g[0].at += g[0].dy, g[1].at += g[1].dy, g[2].at += g[2].dy;
        }
        paint->kernel(surface, first, runs, n, paint);
    }
}
