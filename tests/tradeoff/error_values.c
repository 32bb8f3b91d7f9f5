/* tradeoff/error_values.c: errors of colours, depths, texels and shares of a pixel. Called by
 * error.c. */
#include "error.h"

#include <math.h>

#define EACH_PIXEL(t, x, y)                                                                        \
    for (int y = (t)->y0; y < (t)->y1; y++)                                                        \
        for (int x = (t)->x0; x < (t)->x1; x++)                                                    \
            if (oracle_triangle_covers(&(t)->exact, x, y))

static uint16_t pixel(const struct error_triangle *t, int x, int y)
{
    return t->drawn->pixels[y * TRADEOFF_W + x];
}

/* Channel c of a colour, and the steps it has. */
static int channel(uint16_t color, int c)
{
    return c == 0 ? color >> 11 : c == 1 ? color >> 5 & 63 : color & 31;
}

static int full(int c)
{
    return c == 1 ? 63 : 31;
}

/* got - exact, in steps: the numerator is exact. */
static double color_off(const struct error_triangle *t, int x, int y, int c)
{
    uint32_t value[3];

    for (int i = 0; i < 3; i++)
        value[i] = c == 0 ? t->v[i].at.r : c == 1 ? t->v[i].at.g : t->v[i].at.b;
    const wide128 unit = (wide128)t->exact.area * 255;
    const wide128 off = unit * channel(pixel(t, x, y), c) - error_value(t, x, y, value) * full(c);

    return (double)off / (double)unit;
}

void error_color(const struct error_triangle *t)
{
    EACH_PIXEL(t, x, y)
    for (int c = 0; c < 3; c++)
        error_add(fabs(color_off(t, x, y, c)));
}

/* Blocks of 8 x 8 whose pixels are all covered. */
void error_blocks(const struct error_triangle *t)
{
    for (int by = 0; by < TRADEOFF_H; by += 8)
        for (int bx = 0; bx < TRADEOFF_W; bx += 8) {
            double sum[3] = {0, 0, 0};
            int n = 0;

            for (int i = 0; i < 64; i++) {
                const int x = bx + i % 8, y = by + i / 8;

                if (!oracle_triangle_covers(&t->exact, x, y))
                    continue;
                n++;
                for (int c = 0; c < 3; c++)
                    sum[c] += color_off(t, x, y, c);
            }
            for (int c = 0; n == 64 && c < 3; c++)
                error_add(fabs(sum[c]) / 64);
        }
}

void error_depth(const struct error_triangle *t)
{
    const uint32_t z[3] = {t->v[0].at.z_q16, t->v[1].at.z_q16, t->v[2].at.z_q16};
    const wide128 unit = (wide128)t->exact.area * 65536;

    EACH_PIXEL(t, x, y)
    {
        const wide128 off = unit * t->drawn->depth[y * TRADEOFF_W + x] - error_value(t, x, y, z);

        error_add(fabs((double)off / (double)unit));
    }
}

/* The code of inverse.h as a real number. */
static double code_of(double q)
{
    int e;
    const double m = frexp(q, &e);

    return q < 1 ? 0 : 2048.0 * (e - 1 + 2 * m - 1);
}

void error_code(const struct error_triangle *t)
{
    uint32_t q[3];

    for (int i = 0; i < 3; i++) {
        const uint32_t z = t->v[i].at.z_q16;

        q[i] = z > UINT32_C(0xFFFF0000) ? 0 : UINT32_C(0xFFFF0000) - (z < 0xF0000 ? 0xF0000 : z);
    }
    EACH_PIXEL(t, x, y)
    {
        const double exact = (double)error_value(t, x, y, q) / (double)t->exact.area;

        error_add(fabs(65535 - t->drawn->depth[y * TRADEOFF_W + x] - code_of(exact)));
    }
}

/* From the centre of texel `got`, which repeats. */
static double texel_off(int got, double exact)
{
    const double off = fabs(fmod(got + 0.5 - exact, TRADEOFF_TEXTURE));

    return off > TRADEOFF_TEXTURE / 2.0 ? TRADEOFF_TEXTURE - off : off;
}

void error_texel(const struct error_triangle *t)
{
    const bool parallel = t->v[0].w == t->v[1].w && t->v[0].w == t->v[2].w;

    EACH_PIXEL(t, x, y)
    {
        long double u = 0, v = 0, w = 0;

        for (int i = 0; i < 3; i++) {
            const struct etch_texture_vertex *const p = &t->v[t->exact.from[i]];
            const long double weight = (long double)oracle_triangle_edge(&t->exact, i, x, y) /
                                       (parallel ? 1 : p->w);

            u += weight * p->u, v += weight * p->v, w += weight;
        }
        const double off_u = texel_off(pixel(t, x, y) & 255, (double)(u / w / 65536));
        const double off_v = texel_off(pixel(t, x, y) >> 8, (double)(v / w / 65536));

        error_add(off_u > off_v ? off_u : off_v);
    }
}

/* ---- the share of a pixel
 * ------------------------------------------------------------------------ */

struct corner {
    double x, y;
};

/* What is left of a polygon where a x + b y <= c; returns its corners. */
static int cut(struct corner *p, int n, double a, double b, double c)
{
    struct corner out[16];
    int m = 0;

    for (int i = 0; i < n; i++) {
        const struct corner from = p[i], to = p[(i + 1) % n];
        const double f = a * from.x + b * from.y - c, g = a * to.x + b * to.y - c;

        if (f <= 0)
            out[m++] = from;
        if ((f < 0 && g > 0) || (f > 0 && g < 0)) {
            const double s = f / (f - g);

            out[m++] = (struct corner){from.x + s * (to.x - from.x), from.y + s * (to.y - from.y)};
        }
    }
    for (int i = 0; i < m; i++)
        p[i] = out[i];
    return m;
}

static double share(const struct error_triangle *t, int x, int y)
{
    struct corner p[16];
    double twice = 0;
    int n = 3;

    for (int i = 0; i < 3; i++)
        p[i] = (struct corner){t->v[i].at.x_q8 / 256.0 - x, t->v[i].at.y_q8 / 256.0 - y};
    n = cut(p, n, -1, 0, 0);
    n = cut(p, n, 1, 0, 1);
    n = cut(p, n, 0, -1, 0);
    n = cut(p, n, 0, 1, 1);
    for (int i = 0; i < n; i++)
        twice += p[i].x * p[(i + 1) % n].y - p[(i + 1) % n].x * p[i].y;
    return fabs(twice) / 2;
}

/* Only pixels that an edge crosses, or that are wrong: inside and outside all modes are right. */
void error_coverage(const struct error_triangle *t)
{
    for (int y = t->y0; y < t->y1; y++)
        for (int x = t->x0; x < t->x1; x++) {
            const double exact = share(t, x, y), got = (pixel(t, x, y) >> 5 & 63) / 63.0;

            if ((exact > 1e-9 && exact < 1 - 1e-9) || fabs(got - exact) > 1e-6)
                error_add(fabs(got - exact));
        }
}
