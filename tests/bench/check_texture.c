/* bench/check_texture.c: W12 and W13, coverage by edge functions, texels by real arithmetic on the
 * exact integers. See check.h.
 *
 * A pixel is right if a texel within 1/64 of its coordinates has its colour. W13 may be linear
 * between multiples of 16, held to the range of the vertices, or exact at every pixel.
 */
#include <math.h>
#include <stddef.h>

#include "check.h"

#define NEAR (1.0 / 64)

static uint16_t texels[WL_TEXN * WL_TEXN];

/* Barycentric weights of a point given in half pixels from the pixel centre grid; area > 0. */
struct weights {
    double w[3];
};

static double edge(const wl_tri *t, int a, int b, double x, double y)
{
    return (t->x[b] - t->x[a]) * (y - t->y[a]) - (t->y[b] - t->y[a]) * (x - t->x[a]);
}

/* Integers, hence exact. */
static struct weights weights_at(const wl_tri *t, int x, int y)
{
    const struct weights w = {{edge(t, 1, 2, x, y), edge(t, 2, 0, x, y), edge(t, 0, 1, x, y)}};

    return w;
}

static bool covered(const wl_tri *t, const struct weights *w)
{
    for (int i = 0; i < 3; i++) {
        const int a = (i + 1) % 3, b = (i + 2) % 3;
        const bool top = t->y[a] == t->y[b] && t->x[a] < t->x[b], left = t->y[b] < t->y[a];

        if (w->w[i] < 0 || (w->w[i] == 0 && !top && !left))
            return false;
    }
    return true;
}

struct coordinates {
    double u, v;
};

static struct coordinates coordinates_at(const wl_tri *t, int x, int y, bool perspective)
{
    const struct weights w = weights_at(t, x, y);
    struct coordinates c = {0, 0};
    double all = 0;

    for (int i = 0; i < 3; i++) {
        const double weight = perspective ? w.w[i] / t->w[i] : w.w[i];

        all += weight;
        c.u += weight * t->u[i];
        c.v += weight * t->v[i];
    }
    c.u /= all, c.v /= all;
    return c;
}

static double held(double c, const uint8_t of[3])
{
    return fmin(fmax(c, fmin(of[0], fmin(of[1], of[2]))), fmax(of[0], fmax(of[1], of[2])));
}

static bool texel_is(const wl_tri *t, struct coordinates c, uint16_t color)
{
    for (int i = 0; i < 9; i++) {
        const int u = (int)floor(held(c.u, t->u) + NEAR * (i % 3 - 1));
        const int v = (int)floor(held(c.v, t->v) + NEAR * (i / 3 - 1));

        if (texels[(v & (WL_TEXN - 1)) * WL_TEXN + (u & (WL_TEXN - 1))] == color)
            return true;
    }
    return false;
}

static struct coordinates chord_at(const wl_tri *t, int x, int y)
{
    const struct coordinates a = coordinates_at(t, x & ~15, y, true);
    const struct coordinates b = coordinates_at(t, (x & ~15) + 16, y, true);
    const double in = (x & 15) / 16.0;
    const struct coordinates c = {a.u + (b.u - a.u) * in, a.v + (b.v - a.v) * in};

    return c;
}

static bool color_is_right(const wl_tri *t, int x, int y, bool perspective, uint16_t color)
{
    return texel_is(t, coordinates_at(t, x, y, perspective), color) ||
           (perspective && texel_is(t, chord_at(t, x, y), color));
}

static void pixel(struct check *c, const wl_tri *t, int x, int y, int pass)
{
    const struct weights w = weights_at(t, x, y);
    const uint16_t color = c->color[y * WL_W + x];

    if (!covered(t, &w))
        return;
    const int64_t z = (int64_t)floor((w.w[0] * t->z[0] + w.w[1] * t->z[1] + w.w[2] * t->z[2]) *
                                     65536 / wl_area2(t->x, t->y));

    if (pass < 2)
        c->pixels++;
    if (pass == 0) {
        c->expected[y][x].drawn = true;
        c->matched[y][x] = color_is_right(t, x, y, false, color);
    }
    if (pass == 1 && z < c->least[y][x])
        c->least[y][x] = z;
    /* Two triangles closer than the tolerance of both may win either way. */
    if (pass == 2 && z <= c->least[y][x] + 2 * CHECK_TOLERANCE)
        c->matched[y][x] = c->matched[y][x] || color_is_right(t, x, y, true, color);
}

void check_textures(struct check *c)
{
    static wl_tri list[WL_NBIG];
    const bool depth = c->depth != NULL;

    wl_make_big(list);
    wl_make_texture(texels);
    c->primitives = WL_NBIG;
    for (int pass = depth; pass <= 2 * depth; pass++)
        for (int i = 0; i < WL_NBIG; i++)
            for (int y = 0; y < WL_H; y++)
                for (int x = 0; x < WL_W; x++)
                    pixel(c, &list[i], x, y, pass);
}
