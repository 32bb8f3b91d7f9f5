/* tests/unit: texture in perspective against exact rationals: the divide within its bound, and the
 * kernels by the texel (exact, or linear between multiples of 16 columns), never outside the range
 * of the vertices, at any ratio of w and in every order of the vertices. */
#include "core/draw/texture.h"
#include "core/draw/texture_small.h"
#include "core/fragment/texture.h"
#include "core/fragment/texture_divide.h"
#include "core/fragment/texture_small.h"
#include "core/raster/texture_plane.h"
#include "tests/harness/canvas.h"
#include "tests/harness/shapes.h"
#include "tests/oracle/texture.h"

void suite_texture_perspective(void);

static struct test_canvas canvas;
static int32_t pixels, blocks, exacts;

static const struct etch_rect windows[] = {
    {0, 0, 40, 30}, {280, 200, 320, 230}, {1003, 1013, 1043, 1043}, {100, 50, 164, 80}};

struct sample {
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
static bool make_sample(struct sample *s, int32_t i, uint32_t *seed)
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

    s->window = windows[i / TEST_TRIANGLE_KINDS % 4];
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

static void note(const struct sample *s, int32_t x, int32_t y)
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

static int64_t least_of(const int32_t c[3])
{
    return c[0] < c[1] ? (c[0] < c[2] ? c[0] : c[2]) : (c[1] < c[2] ? c[1] : c[2]);
}

static int64_t most_of(const int32_t c[3])
{
    return c[0] > c[1] ? (c[0] > c[2] ? c[0] : c[2]) : (c[1] > c[2] ? c[1] : c[2]);
}

/* The bound of raster/texture_plane.h in 2^-28 texel, rounded up, at a pixel of the triangle. */
static int64_t bound_of(const struct sample *s, const int32_t c[3], int32_t x, int32_t y)
{
    const int32_t w[3] = {(int32_t)s->w[0], (int32_t)s->w[1], (int32_t)s->w[2]};
    const int64_t span = most_of(c) - least_of(c);
    const int64_t ratio_q16 = (most_of(w) * 65536 + least_of(w) - 1) / least_of(w);
    const int32_t across = s->t.x1 - s->t.x0, down = s->t.y1 - s->t.y0;
    const int32_t length = across + down < 1024 ? across + down : 0, far = (x + y) / 2;
    const int64_t pixels_far = (length > far ? length : far) + 32;
    const int64_t planes = ((span >> 6) + 1) * ((ratio_q16 * pixels_far >> 14) + 1) >> 12;

    return planes + (span >> 13) + (1 << 16);
}

static int64_t exact_at(const struct sample *s, const int32_t c[3], int32_t x, int32_t y)
{
    return (int64_t)oracle_texture(&s->exact, x, y, c, s->w, 12) - (INT64_C(1) << 43);
}

/* |got - exact| in 2^-28 texel; `got` against the middle, 1/4096 texel. */
static int64_t error_of(const struct etch_perspective_axis *a, int32_t got, int64_t exact)
{
    const int64_t mine = (int64_t)(int32_t)a->middle * 4096 + (int64_t)got * 65536;

    return mine < exact ? exact - mine : mine - exact;
}

static void check_divide(const struct sample *s, int32_t x, int32_t y)
{
    const struct etch_texel_ratio ratio = {etch_ratio_at(&s->planes.u.numerator, x, y),
                                           etch_ratio_at(&s->planes.v.numerator, x, y),
                                           etch_ratio_at(&s->planes.denominator, x, y)};
    struct etch_texel_offset at;

    etch_texel_divide(&at, &s->planes, &ratio);
    pixels++;
    if (!CHECK(error_of(&s->planes.u, at.u, exact_at(s, s->u, x, y)) <= bound_of(s, s->u, x, y)) ||
        !CHECK(error_of(&s->planes.v, at.v, exact_at(s, s->v, x, y)) <= bound_of(s, s->v, x, y))) {
        note(s, x, y);
        test_note("error", error_of(&s->planes.u, at.u, exact_at(s, s->u, x, y)));
        test_note("bound", bound_of(s, s->u, x, y));
        test_note("error v", error_of(&s->planes.v, at.v, exact_at(s, s->v, x, y)));
        test_note("bound v", bound_of(s, s->v, x, y));
    }
}

static void divide_keeps_its_bound(void)
{
    uint32_t seed = 57;
    int32_t i, x, y;

    for (i = 0; i < TEST_COUNT(2400) && !test_failed(); i++) {
        struct sample s;

        if (!make_sample(&s, i, &seed))
            continue;
        for (y = s.window.y0; y < s.window.y1; y++)
            for (x = s.window.x0; x < s.window.x1; x++)
                if (oracle_triangle_covers(&s.exact, x, y))
                    check_divide(&s, x, y);
    }
}

/* A texture of numbers, so large that no triangle here repeats it. */
static uint16_t numbers[65536];
static const struct etch_texture texture = {numbers, 8, 8};

static void draw(const struct sample *s, const uint8_t order[3], int painter)
{
    const struct etch_texture_vertex *const v[3] = {&s->vertex[order[0]], &s->vertex[order[1]],
                                                    &s->vertex[order[2]]};
    static const struct etch_perspective_kernels *const kernels[] = {
        &etch_perspective,        &etch_perspective_exact,      &etch_perspective_less,
        &etch_perspective_lequal, &etch_perspective_exact_less, &etch_perspective_exact_lequal};

    if (painter == 6)
        etch_triangle_perspective_depth_small(&canvas.surface, v, &texture,
                                              etch_kernel_perspective_less_small);
    else if (painter < 2)
        etch_triangle_perspective(&canvas.surface, v, &texture, kernels[painter]);
    else
        etch_triangle_perspective_depth(&canvas.surface, v, &texture, kernels[painter]);
}

/* Whether `texel` is one within `near` of `place` (2^-28 texel) held to the range of c. */
static bool is_near(const int32_t c[3], int64_t place, int64_t near, uint32_t texel)
{
    const int64_t least = least_of(c) * 4096, most = most_of(c) * 4096;
    int64_t lo = place - near, hi = place + near;

    lo = lo < least ? least : lo > most ? most : lo;
    hi = hi < least ? least : hi > most ? most : hi;
    for (lo >>= 28, hi >>= 28; lo <= hi; lo++)
        if (((uint64_t)lo & 255) == texel)
            return true;
    return false;
}

/* One coordinate of a pixel: exact, or on the line between the ends of its block. */
static bool texel_ok(const struct sample *s, const int32_t c[3], uint32_t texel, bool by_blocks,
                     int32_t x, int32_t y)
{
    const int64_t bound = bound_of(s, c, x, y);

    if (!by_blocks)
        return is_near(c, exact_at(s, c, x, y), bound, texel);
    const int32_t start = x & ~INT32_C(15);
    const int64_t from = exact_at(s, c, start, y), to = exact_at(s, c, start + 16, y);

    return is_near(c, from + (to - from) * (x - start) / 16, 4 * bound + (15 << 12), texel);
}

static void check_texels(const struct sample *s, bool by_blocks)
{
    int32_t x, y;

    for (y = s->window.y0; y < s->window.y1; y++) {
        for (x = s->window.x0; x < s->window.x1; x++) {
            const uint16_t got = test_canvas_at(&canvas, x, y);

            if (!CHECK(oracle_triangle_covers(&s->exact, x, y)
                           ? texel_ok(s, s->u, got & 255, by_blocks, x, y) &&
                                 texel_ok(s, s->v, got >> 8, by_blocks, x, y)
                           : got == TEST_BACKGROUND))
                note(s, x, y);
        }
    }
    CHECK_ONCE(&canvas);
}

/* Every kernel, at every ratio of w: the texel is near the exact one and between those of the
 * vertices. */
static void kernels_take_the_right_texel(void)
{
    uint32_t seed = 58;
    int32_t i;

    for (i = 0; i < 65536; i++)
        numbers[i] = (uint16_t)i;
    for (i = 0; i < TEST_COUNT(2400) && !test_failed(); i++) {
        const int painter = i % 7;
        struct sample s;

        if (!make_sample(&s, i, &seed) || (s.w[0] == s.w[1] && s.w[0] == s.w[2]))
            continue;
        test_canvas_open(&canvas, s.window);
        draw(&s, test_orders[i / 7 % 6], painter);
        check_texels(&s, s.blocks && painter != 1 && painter < 4);
        blocks += s.blocks;
        exacts += !s.blocks;
    }
}

void suite_texture_perspective(void)
{
    pixels = blocks = exacts = 0;
    RUN(divide_keeps_its_bound);
    RUN(kernels_take_the_right_texel);
    test_print_count("", pixels, " divides against exact rationals, none beyond its bound");
    test_print_count("", blocks, " triangles by blocks of 16");
    test_print_count("", exacts, " that need a divide a pixel");
}
