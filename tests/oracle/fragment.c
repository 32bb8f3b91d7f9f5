/* tests/oracle: a fragment through the pipeline. See fragment.h. */
#include "fragment.h"

#include <stddef.h>

#include "texture.h"

static const int64_t full[3] = {31, 63, 31};
static const int shifts[3] = {11, 5, 0};

/* What values may err by before they decide something: 1/64 of a unit of what is compared. */
static bool is_near(int64_t value, int64_t limit, int64_t unit)
{
    const int64_t off = value - limit;

    return (off < 0 ? -off : off) * 64 <= unit;
}

static int64_t least(int64_t a, int64_t b)
{
    return a < b ? a : b;
}

/* A varying of whole numbers below 2^8 (bits 22) or 2^16 (bits 14), in 2^-bits. */
static int64_t varying(const struct oracle_triangle *t, int32_t x, int32_t y, const int32_t c[3],
                       const uint32_t w[3], int bits)
{
    const int32_t scale = (int32_t)1 << bits;
    const int32_t scaled[3] = {c[0] * scale, c[1] * scale, c[2] * scale};

    return (int64_t)oracle_texture(t, x, y, scaled, w, 0) - (INT64_C(1) << 31);
}

static bool compare(int function, int64_t a, int64_t b)
{
    switch (function) { /* never less equal lequal greater notequal gequal always */
    case 0: return false;
    case 1: return a < b;
    case 2: return a == b;
    case 3: return a <= b;
    case 4: return a > b;
    case 5: return a != b;
    case 6: return a >= b;
    default: return true;
    }
}

static uint8_t operate(const struct oracle_state *s, int which, uint8_t stored)
{
    static const int step[8] = {0, 0, 0, 1, -1, 0, 1, -1};
    const int operation = s->operation[which];
    int v = stored + step[operation];

    if (operation == 1)
        v = 0;
    if (operation == 2)
        v = s->reference;
    if (operation == 3 || operation == 4)
        v = v < 0 ? 0 : v > 255 ? 255 : v;
    if (operation == 5)
        v = 255 - stored;
    return (uint8_t)(((v & s->write_mask) | (stored & ~s->write_mask)) & 255);
}

/* The texel that holds a coordinate in 2^-20, -1 if that is in doubt. */
static int texel_of(int64_t c, int size, int wrap)
{
    const int64_t one = INT64_C(1) << 20, rest = c & (one - 1);
    int64_t k = (c - rest) / one;

    if (rest * 32 < one || (one - rest) * 32 < one)
        return -1;
    if (wrap == 1)
        return (int)(k < 0 ? 0 : k >= size ? size - 1 : k);
    k = (k % (2 * size) + 2 * size) % (2 * size);
    if (wrap == 0)
        return (int)(k % size);
    return (int)(k < size ? k : 2 * size - 1 - k);
}

/* Replace, modulate, decal: c holds r g b a. */
static bool texture(int64_t c[4], const struct oracle_state *s, const struct oracle_triangle *t,
                    const struct oracle_vertex v[3], const uint32_t *w, int32_t x, int32_t y)
{
    const int32_t us[3] = {v[0].u, v[1].u, v[2].u}, vs[3] = {v[0].v, v[1].v, v[2].v};
    const int64_t bias = INT64_C(1) << 35;
    const int i = texel_of((int64_t)oracle_texture(t, x, y, us, w, 4) - bias, s->width, s->wrap);
    const int j = texel_of((int64_t)oracle_texture(t, x, y, vs, w, 4) - bias, s->height, s->wrap);

    if (i < 0 || j < 0)
        return false;
    const uint16_t texel = s->texels[j * s->width + i];
    const int64_t a = s->texel_alpha[j * s->width + i];

    for (int k = 0; k < 3; k++) {
        const int64_t color = ORACLE_ONE * (texel >> shifts[k] & full[k]) / full[k];

        c[k] = s->tex == 1   ? color
               : s->tex == 2 ? (c[k] >> 1) * (color >> 1) / (ORACLE_ONE >> 2)
                             : (c[k] * (255 - a) + color * a) / 255;
    }
    if (s->tex == 1)
        c[3] = ORACLE_ONE * a / 255;
    if (s->tex == 2)
        c[3] = c[3] * a / 255;
    return true;
}

/* exp(-x), x in 2^-30 below 2^36: the series of x / 1024, squared ten times. */
static int64_t exponential(int64_t x)
{
    int64_t term = ORACLE_ONE, sum = 0;

    for (int k = 1; k < 12; k++) {
        sum += (k & 1) != 0 ? term : -term;
        term = term * (x >> 10) / ORACLE_ONE / k;
        if (term > 64 * ORACLE_ONE)
            return 0;
    }
    for (int k = 0; k < 10; k++)
        sum = sum * sum / ORACLE_ONE;
    return sum;
}

static void fog(int64_t c[4], const struct oracle_state *s, int64_t z)
{
    int64_t f = s->fog == 1 ? (s->end - z) * ORACLE_ONE / (s->end - s->start)
                            : exponential(s->density * z * (ORACLE_ONE >> 16) / 65535);

    f = f < 0 ? 0 : least(f, ORACLE_ONE);
    for (int k = 0; k < 3; k++)
        c[k] = (c[k] * f + ORACLE_ONE * s->fog_rgb[k] / 255 * (ORACLE_ONE - f)) / ORACLE_ONE;
}

/* Alpha, stencil, depth; what becomes of the planes is in out. */
static void test(struct oracle_fragment *out, const struct oracle_state *s, const int64_t c[4],
                 int64_t z, uint8_t flat_alpha)
{
    struct oracle_pixel *const p = &out->pixel;

    if (s->atest >= 0) {
        const bool sure = s->flat && s->tex == 0;
        const int64_t a = c[3] * 255;

        out->doubtful |= !sure && is_near(a, s->atest * ORACLE_ONE, ORACLE_ONE);
        if (sure ? flat_alpha < s->atest : a < s->atest * ORACLE_ONE)
            return;
    }
    if (s->stencil != 0 && !compare(s->stencil - 1, s->reference & s->mask, p->stencil & s->mask)) {
        p->stencil = operate(s, 0, p->stencil);
        return;
    }
    if (s->ztest != 0 && !compare(s->ztest - 1, z, p->depth)) {
        p->stencil = s->stencil != 0 ? operate(s, 1, p->stencil) : p->stencil;
        return;
    }
    if (s->stencil != 0)
        p->stencil = operate(s, 2, p->stencil);
    if (s->ztest != 0 && s->zwrite != 0)
        p->depth = (uint16_t)z;
    out->drawn = true;
}

/* The channels after blending, in output steps 2^-30. */
static void blend(struct oracle_fragment *out, const struct oracle_state *s, const int64_t c[4],
                  uint16_t before)
{
    for (int k = 0; k < 3; k++) {
        const int64_t steps = c[k] * full[k], d = (before >> shifts[k] & full[k]) * ORACLE_ONE;
        const int64_t a = s->blend == 5 ? ORACLE_ONE * s->constant / 255 : c[3];
        const int64_t most = full[k] * ORACLE_ONE, a20 = a >> 10, one = ORACLE_ONE >> 10;

        out->channel[k] = s->blend == 1 || s->blend == 5 ? (steps * a20 + d * (one - a20)) / one
                          : s->blend == 2                ? least(steps + d, most)
                          : s->blend == 3                ? steps / full[k] * (d / ORACLE_ONE)
                          : s->blend == 4                ? least(steps * a20 / one + d, most)
                                                         : steps;
    }
}

/* The bits of a raster operation, if the rounding of S is not in doubt. */
static void logic(struct oracle_fragment *out, const struct oracle_state *s, const int64_t c[4],
                  uint16_t before)
{
    unsigned source = 0, result = 0;

    for (int k = 0; k < 3; k++) {
        const int64_t steps = c[k] * full[k], half = ORACLE_ONE / 2;

        out->doubtful |= is_near((steps + half) % ORACLE_ONE, 0, ORACLE_ONE) ||
                         is_near((steps + half) % ORACLE_ONE, ORACLE_ONE, ORACLE_ONE);
        source |= (unsigned)((steps + half) / ORACLE_ONE) << shifts[k];
    }
    for (int bit = 0; bit < 16; bit++)
        result |= ((unsigned)s->logic >> ((source >> bit & 1) * 2 + (before >> bit & 1)) & 1)
                  << bit;
    out->exact = true;
    out->pixel.color = (uint16_t)((result & (unsigned)s->color_mask) |
                                  (before & ~(unsigned)s->color_mask));
}

/* From texture on: c holds r g b a, flat_alpha what alpha is exactly where the state is flat. */
static void pass(struct oracle_fragment *out, const struct oracle_state *s, int64_t c[4],
                 int64_t z14, uint8_t flat_alpha, struct oracle_pixel before)
{
    const int64_t z = (z14 + (1 << 13)) >> 14, rest = (z14 + (1 << 13)) & 16383;

    if (s->ztest != 0 || s->fog != 0)
        out->doubtful |= is_near(rest, 0, 16384) || is_near(rest, 16384, 16384);
    if (s->fog != 0)
        fog(c, s, z);
    test(out, s, c, z, flat_alpha);
    if (!out->drawn)
        return;
    if (s->logic >= 0)
        logic(out, s, c, before.color);
    else
        blend(out, s, c, before.color);
}

void oracle_fragment(struct oracle_fragment *out, const struct oracle_state *s,
                     const struct oracle_triangle *t, const struct oracle_vertex v[3], int32_t x,
                     int32_t y, struct oracle_pixel before)
{
    const uint32_t distances[3] = {v[0].w, v[1].w, v[2].w}, *const w = s->persp ? distances : NULL;
    const int32_t zs[3] = {v[0].z, v[1].z, v[2].z};
    const bool level = zs[0] == zs[1] && zs[0] == zs[2];
    const int64_t z14 = level ? zs[0] * INT64_C(16384) : varying(t, x, y, zs, NULL, 14);
    int64_t c[4];
    const struct oracle_fragment start = {.pixel = before};

    *out = start;
    for (int k = 0; k < 4; k++) {
        const int32_t cs[3] = {v[0].rgba[k], v[1].rgba[k], v[2].rgba[k]};

        c[k] = s->flat ? ORACLE_ONE * cs[0] / 255 : varying(t, x, y, cs, w, 22) * 256 / 255;
    }
    if (s->tex != 0)
        out->doubtful = !texture(c, s, t, v, w, x, y);
    pass(out, s, c, z14, v[0].rgba[3], before);
}

void oracle_line_fragment(struct oracle_fragment *out, const struct oracle_state *s,
                          const struct oracle_vertex v[2], int64_t k, int64_t length,
                          struct oracle_pixel before)
{
    const int64_t du = length != 0 ? length : 2, at = length != 0 ? k : 1;
    int64_t c[4];
    const struct oracle_fragment start = {.pixel = before};

    *out = start;
    for (int i = 0; i < 4; i++) {
        const int64_t a = v[0].rgba[i], b = s->flat ? a : v[1].rgba[i];

        c[i] = (a * (du - at) + b * at) * ORACLE_ONE / (255 * du);
    }
    pass(out, s, c, (v[0].z * (du - at) + v[1].z * at) * 16384 / du, v[0].rgba[3], before);
}

bool oracle_fragment_color_ok(const struct oracle_fragment *f, const struct oracle_state *s,
                              struct oracle_pixel before, uint16_t color, int64_t bound)
{
    if (!f->drawn || f->exact)
        return color == f->pixel.color;
    for (int k = 0; k < 3; k++) {
        const int64_t got = (color >> shifts[k] & full[k]) * ORACLE_ONE;
        const int64_t off = got - f->channel[k];

        if ((s->color_mask >> shifts[k] & 1) == 0) {
            if ((color >> shifts[k] & full[k]) != (before.color >> shifts[k] & full[k]))
                return false;
        } else if ((off < 0 ? -off : off) > ORACLE_ONE / 2 + bound) {
            return false;
        }
    }
    return true;
}
