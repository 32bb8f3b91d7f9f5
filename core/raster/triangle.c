/* raster/triangle.c: set-up and edge walk, triangles to runs. Called by draw/ with a paint.
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
 */
#include "triangle.h"

struct edge {
    int32_t x, e;    /* of the current row; 0 <= e < dy */
    int32_t dy;      /* 1 .. 2^24 */
    int32_t quotient, remainder; /* of dx / dy, remainder 0 .. dy - 1 */
};

static bool is_above(struct etch_point_q8 a, struct etch_point_q8 b)
{
    return a.y < b.y || (a.y == b.y && a.x < b.x);
}

static void exchange(struct etch_triangle *t, int i, int j)
{
    const struct etch_point_q8 p = t->p[i];
    const uint8_t o = t->order[i];

    t->p[i] = t->p[j], t->order[i] = t->order[j];
    t->p[j] = p, t->order[j] = o;
    t->winding = (int8_t)-t->winding;
}

/* Twice the signed area of p: positive if the middle vertex is right of the long edge. */
static int64_t doubled_area(const struct etch_triangle *t)
{
    const int32_t x1 = t->p[1].x - t->p[0].x, y1 = t->p[1].y - t->p[0].y;
    const int32_t x2 = t->p[2].x - t->p[0].x, y2 = t->p[2].y - t->p[0].y;

    if (t->most - t->least < INT32_C(1) << 15 && y2 < INT32_C(1) << 15) /* 128 px: products below 2^30 */
        return x1 * y2 - x2 * y1;
    return etch_mul_s32(x1, y2) - etch_mul_s32(x2, y1);
}

/* The first row whose centre is at or below y. */
static int16_t row_of(int32_t y_q8)
{
    const int32_t row = (y_q8 + 127) >> 8;

    return row < INT16_MAX ? (int16_t)row : INT16_MAX; /* no surface has row 32767 */
}

static void bounds(struct etch_triangle *t)
{
    const int32_t ax = t->p[0].x, bx = t->p[1].x, cx = t->p[2].x;

    t->least = ax < bx ? (ax < cx ? ax : cx) : bx < cx ? bx : cx;
    t->most = ax > bx ? (ax > cx ? ax : cx) : bx > cx ? bx : cx;
    t->y0 = row_of(t->p[0].y);
    t->y1 = row_of(t->p[2].y);
}

bool etch_triangle_setup(struct etch_triangle *t, const struct etch_point_q8 v[3])
{
    for (uint8_t i = 0; i < 3; i++)
        t->p[i] = v[i], t->order[i] = i;
    t->winding = 1;
    if (is_above(t->p[1], t->p[0]))
        exchange(t, 0, 1);
    if (is_above(t->p[2], t->p[1])) {
        exchange(t, 1, 2);
        if (is_above(t->p[1], t->p[0]))
            exchange(t, 0, 1);
    }

    bounds(t);

    const int64_t area = doubled_area(t);

    t->area = area < 0 ? (uint64_t)-area : (uint64_t)area;
    t->side = area > 0 ? 1 : -1;
    t->winding = (int8_t)(t->winding * t->side);
    return area != 0;
}

bool etch_triangle_is_visible(const struct etch_triangle *t, struct etch_rect clip)
{
    return t->y0 < clip.y1 && t->y1 > clip.y0 && t->y0 < t->y1 &&
           (t->least + 127) >> 8 < clip.x1 && (t->most + 127) >> 8 > clip.x0;
}

/* *n becomes the remainder 0 .. d - 1, the result is the floored quotient. Quotients of edges
 * are small: a division only where |n| >= 4 d. */
static int32_t divide_floor(int32_t *n, int32_t d)
{
    int32_t q = 0;

    if (*n >= d << 2 || *n < -(d << 2)) {
        q = *n / d;
        *n -= q * d;
    }
    for (; *n < 0; q--)
        *n += d;
    for (; *n >= d; q++)
        *n -= d;
    return q;
}

/* Moves an edge k rows down at once. k <= 2^16, so k * remainder < 2^40. */
static void edge_skip(struct edge *g, uint32_t k)
{
    const uint64_t down = (uint64_t)k * (uint32_t)g->remainder;
    const struct etch_quotient r = etch_divide_u64(down, (uint64_t)g->dy);

    g->x += (int32_t)k * g->quotient + (int32_t)r.quotient;
    g->e -= (int32_t)r.remainder;
    if (g->e < 0)
        g->e += g->dy, g->x++;
}

/* Puts the edge a, b on row y, which its height must contain. */
static void edge_start(struct edge *g, struct etch_point_q8 a, struct etch_point_q8 b, int16_t y)
{
    const int32_t dx = b.x - a.x, dy = b.y - a.y;
    const int32_t first = (a.y + 127) >> 8;
    const int32_t k = first * 256 + 128 - a.y; /* 0 .. 255, from a down to its first centre */
    const int32_t f = (a.x - 128) & 255;       /* the fraction of a.x against centres */
    /* M less the whole pixels of a.x; in halves so that no product passes 2^25 */
    int32_t m = f * (dy >> 8) + k * (dx >> 8) + ((f * (dy & 255) + k * (dx & 255) + 255) >> 8);
    int32_t step = dx;

    g->dy = dy;
    g->quotient = divide_floor(&step, dy);
    g->remainder = step;
    m = -m; /* ceil(m / dy) = -floor(-m / dy), and e is then that floor's remainder */
    g->x = ((a.x - 128) >> 8) - divide_floor(&m, dy);
    g->e = m;
    if (y > first)
        edge_skip(g, (uint32_t)(y - first));
}

/* Writes the edge's x of the next n rows to *out, out[2], out[4] ..; held to lo .. hi. */
static int16_t *edge_walk(struct edge *g, int16_t *out, int16_t n, int16_t lo, int16_t hi)
{
    int32_t x = g->x, e = g->e;
    const int32_t dy = g->dy, quotient = g->quotient, remainder = g->remainder;

    for (; n > 0; n--, out += 2) {
        *out = x < lo ? lo : x > hi ? hi : (int16_t)x;
        x += quotient;
        e -= remainder;
        if (e < 0)
            e += dy, x++;
    }
    g->x = x;
    g->e = e;
    return out;
}

void etch_triangle_runs(const struct etch_surface *surface, const struct etch_triangle *t,
                        const struct etch_paint *paint)
{
    const struct etch_rect clip = surface->clip;
    int16_t y = t->y0 > clip.y0 ? t->y0 : clip.y0;
    const int16_t y1 = t->y1 < clip.y1 ? t->y1 : clip.y1;
    const int16_t bend = row_of(t->p[1].y);      /* below it the lower short edge bounds */
    const int16_t lower = bend > y ? bend : y;   /* the row where that edge starts */
    struct etch_run runs[ETCH_RUN_BLOCK];
    int16_t *const far = t->side > 0 ? &runs[0].x0 : &runs[0].x1;  /* bound of p[0] p[2] */
    int16_t *const near = t->side > 0 ? &runs[0].x1 : &runs[0].x0; /* of the short edges */
    struct edge whole, part; /* p[0] p[2]; p[0] p[1] and later p[1] p[2] */

    if (y >= y1 || clip.x0 >= clip.x1)
        return;
    edge_start(&whole, t->p[0], t->p[2], y);
    if (y < lower)
        edge_start(&part, t->p[0], t->p[1], y);
    while (y < y1) {
        const int16_t n = (int16_t)(y1 - y < ETCH_RUN_BLOCK ? y1 - y : ETCH_RUN_BLOCK);
        const int16_t upper = (int16_t)(y >= lower ? 0 : lower - y < n ? lower - y : n);
        int16_t *out = near;

        edge_walk(&whole, far, n, clip.x0, clip.x1);
        if (upper > 0)
            out = edge_walk(&part, out, upper, clip.x0, clip.x1);
        if (y + upper == lower && lower < y1)
            edge_start(&part, t->p[1], t->p[2], lower);
        if (upper < n)
            edge_walk(&part, out, (int16_t)(n - upper), clip.x0, clip.x1);
        paint->kernel(surface, y, runs, (uint8_t)n, paint);
        y = (int16_t)(y + n);
    }
}
