/* bench/check_triangle.c: W6..W11, coverage by edge functions and values by exact rationals.
 * See check.h. */
#include <stdlib.h>

#include "check.h"

__extension__ typedef __int128 wide;

static const int32_t greatest[3] = {31, 63, 31};

/* Positive right of the edge a -> b as seen (y down), in (1/256 px)^2. */
static int64_t edge(const struct check_vertex *a, const struct check_vertex *b, int32_t x,
                    int32_t y)
{
    return (int64_t)(b->x_q8 - a->x_q8) * (y - a->y_q8) -
           (int64_t)(b->y_q8 - a->y_q8) * (x - a->x_q8);
}

/* Of a clockwise triangle: top edges run right, left edges run up. */
static bool inside(const struct check_vertex *a, const struct check_vertex *b, int64_t e)
{
    const bool top = a->y_q8 == b->y_q8 && a->x_q8 < b->x_q8, left = b->y_q8 < a->y_q8;

    return e > 0 || (e == 0 && (top || left));
}

bool check_color(uint16_t color, const int32_t exact[3])
{
    const int32_t drawn[3] = {color >> 11, color >> 5 & 63, color & 31};

    for (int i = 0; i < 3; i++)
        if (abs(drawn[i] * 65536 - exact[i]) > CHECK_TOLERANCE)
            return false;
    return true;
}

/* A flat colour in 1/65536 step: as RGB565, or 8-bit channels rounded to it (no ties). */
static void flat_channels(int32_t out[3], uint16_t color, bool rounded)
{
    const int32_t whole[3] = {color >> 11, color >> 5 & 63, color & 31};
    const int32_t bits[3] = {wl_r8(color), wl_g8(color), wl_b8(color)};

    for (int i = 0; i < 3; i++)
        out[i] = (rounded ? (bits[i] * greatest[i] * 2 + 255) / 510 : whole[i]) * 65536;
}

static void pixel(struct check *c, int x, int y, const int32_t channel[3], int64_t z, int pass)
{
    struct expected *e = &c->expected[y][x];

    if (pass < 2)
        c->pixels++;
    if (pass == 1 && z < c->least[y][x])
        c->least[y][x] = z;
    /* Two triangles closer than the tolerance of both may win either way. */
    if (pass == 2 && z <= c->least[y][x] + 2 * CHECK_TOLERANCE &&
        check_color(c->color[y * WL_W + x], channel))
        c->matched[y][x] = true;
    if (pass == 0) {
        e->drawn = true;
        for (int i = 0; i < 3; i++)
            e->channel[i] = channel[i];
    }
}

static int32_t least_of(int32_t a, int32_t b, int32_t d)
{
    const int32_t m = a < b ? a : b;

    return m < d ? m : d;
}

void check_triangle(struct check *c, const struct check_vertex v[3], const int32_t *flat, int pass)
{
    const int64_t area = edge(&v[0], &v[1], v[2].x_q8, v[2].y_q8);
    const struct check_vertex *const t[3] = {&v[0], area > 0 ? &v[1] : &v[2],
                                             area > 0 ? &v[2] : &v[1]};
    const int64_t all = area > 0 ? area : -area;
    const int x0 = least_of(v[0].x_q8, v[1].x_q8, v[2].x_q8) >> 8;
    const int x1 = -(least_of(-v[0].x_q8, -v[1].x_q8, -v[2].x_q8) >> 8);
    const int y0 = least_of(v[0].y_q8, v[1].y_q8, v[2].y_q8) >> 8;
    const int y1 = -(least_of(-v[0].y_q8, -v[1].y_q8, -v[2].y_q8) >> 8);

    if (all == 0)
        return;
    for (int y = y0 < 0 ? 0 : y0; y <= y1 && y < WL_H; y++)
        for (int x = x0 < 0 ? 0 : x0; x <= x1 && x < WL_W; x++) {
            int64_t e[3]; /* the weight of the vertex opposite */
            bool in = true;
            for (int i = 0; i < 3; i++) {
                const struct check_vertex *a = t[(i + 1) % 3], *b = t[(i + 2) % 3];
                e[i] = edge(a, b, x * 256 + 128, y * 256 + 128);
                in = in && inside(a, b, e[i]);
            }
            if (!in)
                continue;
            wide z = 0, sum[3] = {0, 0, 0};
            int32_t channel[3];
            for (int i = 0; i < 3; i++) {
                z += (wide)e[i] * t[i]->z_q16;
                for (int k = 0; k < 3; k++)
                    sum[k] += (wide)e[i] * t[i]->channel[k];
            }
            for (int k = 0; k < 3; k++)
                channel[k] = (int32_t)(sum[k] * greatest[k] * 65536 / ((wide)all * 255));
            pixel(c, x, y, flat != NULL ? flat : channel, (int64_t)(z / all), pass);
        }
}

void check_triangles(struct check *c, int workload)
{
    static wl_tri list[WL_NSMALL];
    const bool small = workload == WL_SMALL_FLAT || workload == WL_SMALL_GOURAUD;
    const bool flat = workload == WL_SMALL_FLAT || workload == WL_BIG_FLAT ||
                      workload == WL_BIG_FLAT_Z;
    const bool depth = c->depth != NULL;

    c->primitives = small ? WL_NSMALL : WL_NBIG;
    if (small)
        wl_make_small(list);
    else
        wl_make_big(list);
    for (int pass = depth; pass <= 2 * depth; pass++)
        for (uint32_t i = 0; i < c->primitives; i++) {
            struct check_vertex v[3];
            int32_t color[3];
            flat_channels(color, list[i].c[0], depth);
            for (int k = 0; k < 3; k++) {
                const wl_tri *t = &list[i];
                const struct check_vertex p = {
                    t->x[k] * 256 + 128,
                    t->y[k] * 256 + 128,
                    (uint32_t)t->z[k] << 16,
                    {(uint8_t)wl_r8(t->c[k]), (uint8_t)wl_g8(t->c[k]), (uint8_t)wl_b8(t->c[k])}};
                v[k] = p;
            }
            check_triangle(c, v, flat ? color : NULL, pass);
        }
}
