/* tests/unit: seeded triangles with texture coordinates in perspective, and their exact values;
 * shared by the suites of textures. */
#ifndef TESTS_UNIT_TEXTURE_PARTS_H
#define TESTS_UNIT_TEXTURE_PARTS_H

#include "core/raster/texture_plane.h"
#include "tests/harness/harness.h"
#include "tests/harness/shapes.h"
#include "tests/oracle/texture.h"

static const struct etch_rect texture_windows[] = {
    {0, 0, 40, 30}, {280, 200, 320, 230}, {1003, 1013, 1043, 1043}, {100, 50, 164, 80}};

struct texture_sample {
    struct oracle_triangle exact;
    struct etch_texture_vertex vertex[3];
    struct etch_rect window;
    int32_t u[3], v[3];
    uint32_t w[3];
    struct etch_triangle t;
    struct etch_perspective_planes planes;
    bool blocks; /* as set-up says */
};

/* False if there is no triangle. Kinds of w: ratios up to 2, up to 16, any; in steps, one far. */
static inline bool texture_sample_make(struct texture_sample *s, int32_t i, uint32_t *seed)
{
    const int32_t shape = i % TEST_TRIANGLE_KINDS, kind = test_range(seed, 0, 3);
    const int32_t base = test_range(seed, 1, 4000), texels = 1 << test_range(seed, 0, 8);
    const int32_t u0 = test_range(seed, -300, 300) * 65536,
                  v0 = test_range(seed, -300, 300) * 65536;
    const struct etch_texture_vertex *const v[3] = {&s->vertex[0], &s->vertex[1], &s->vertex[2]};
    struct etch_point_q8 p[3];
    struct test_triangle t;
    struct etch_basis basis;
    int k;

    s->window = texture_windows[i / TEST_TRIANGLE_KINDS % 4];
    test_triangle_make(&t, (enum test_triangle_kind)shape, s->window, seed);
    oracle_triangle_make(&s->exact, t.x, t.y);
    for (k = 0; k < 3; k++) {
        s->u[k] = u0 + test_range(seed, 0, texels) * 65536;
        s->v[k] = v0 + test_range(seed, 0, texels * 65536);
        s->w[k] = (uint32_t)(kind == 0   ? base + test_range(seed, 0, base)
                             : kind == 1 ? base + test_range(seed, 0, 15 * base)
                             : kind == 2 ? test_range(seed, 1, 65535)
                                         : test_range(seed, 0, 1) * 65534 + 1);
        const struct etch_texture_vertex vertex = {
            {t.x[k], t.y[k], (uint32_t)test_range(seed, 0, 65535) << 16, 0, 0, 0, 255},
            s->u[k],
            s->v[k],
            s->w[k]};

        s->vertex[k] = vertex;
        p[k].x = t.x[k];
        p[k].y = t.y[k];
    }
    if (!etch_triangle_setup(&s->t, p))
        return false;
    s->blocks = etch_texture_perspective(&s->planes, &s->t,
                                         etch_basis_setup(&basis, &s->t) ? &basis : NULL, v);
    return true;
}

static inline void texture_sample_note(const struct texture_sample *s, int32_t x, int32_t y)
{
    int i;

    test_note("pixel x", x);
    test_note("pixel y", y);
    test_note("blocks", s->blocks);
    for (i = 0; i < 3; i++) {
        test_note("x_q8", s->vertex[i].at.x_q8);
        test_note("y_q8", s->vertex[i].at.y_q8);
        test_note("u", s->u[i]);
        test_note("v", s->v[i]);
        test_note("w", s->w[i]);
    }
}

static inline int64_t texture_least(const int32_t c[3])
{
    return c[0] < c[1] ? (c[0] < c[2] ? c[0] : c[2]) : (c[1] < c[2] ? c[1] : c[2]);
}

static inline int64_t texture_most(const int32_t c[3])
{
    return c[0] > c[1] ? (c[0] > c[2] ? c[0] : c[2]) : (c[1] > c[2] ? c[1] : c[2]);
}

/* The bound of raster/texture_plane.h in 2^-28 texel, rounded up, at a pixel of the triangle. */
static inline int64_t texture_bound(const struct texture_sample *s, const int32_t c[3], int32_t x,
                                    int32_t y)
{
    const int32_t w[3] = {(int32_t)s->w[0], (int32_t)s->w[1], (int32_t)s->w[2]};
    const int64_t span = texture_most(c) - texture_least(c);
    const int64_t ratio_q16 = (texture_most(w) * 65536 + texture_least(w) - 1) / texture_least(w);
    const int32_t across = s->t.x1 - s->t.x0, down = s->t.y1 - s->t.y0;
    const int32_t length = across + down < 1024 ? across + down : 0, far = (x + y) / 2;
    const int64_t pixels_far = (length > far ? length : far) + 32;
    const int64_t planes = ((span >> 6) + 1) * ((ratio_q16 * pixels_far >> 14) + 1) >> 12;

    return planes + (span >> 13) + (1 << 16);
}

static inline int64_t texture_exact(const struct texture_sample *s, const int32_t c[3], int32_t x,
                                    int32_t y)
{
    return (int64_t)oracle_texture(&s->exact, x, y, c, s->w, 12) - (INT64_C(1) << 43);
}

#endif
