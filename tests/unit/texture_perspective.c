/* tests/unit: texture in perspective against exact rationals: the divide within its bound, and the
 * kernels by the texel (exact, or linear between multiples of 16 columns), never outside the range
 * of the vertices, at any ratio of w and in every order of the vertices. */
#include "core/draw/texture.h"
#include "core/draw/texture_small.h"
#include "core/fragment/texture.h"
#include "core/fragment/texture_divide.h"
#include "core/fragment/texture_small.h"
#include "tests/harness/canvas.h"
#include "texture_parts.h"

void suite_texture_perspective(void);

static struct test_canvas canvas;
static int32_t pixels, blocks, exacts;

/* |got - exact| in 2^-28 texel; `got` against the middle, 1/4096 texel. */
static int64_t error_of(const struct etch_perspective_axis *a, int32_t got, int64_t exact)
{
    const int64_t mine = (int64_t)(int32_t)a->middle * 4096 + (int64_t)got * 65536;

    return mine < exact ? exact - mine : mine - exact;
}

static void check_divide(const struct texture_sample *s, int32_t x, int32_t y)
{
    const struct etch_texel_ratio ratio = {etch_ratio_at(&s->planes.u.numerator, x, y),
                                           etch_ratio_at(&s->planes.v.numerator, x, y),
                                           etch_ratio_at(&s->planes.denominator, x, y)};
    struct etch_texel_offset at;

    etch_texel_divide(&at, &s->planes, &ratio);
    pixels++;
    if (!CHECK(error_of(&s->planes.u, at.u, texture_exact(s, s->u, x, y)) <=
               texture_bound(s, s->u, x, y)) ||
        !CHECK(error_of(&s->planes.v, at.v, texture_exact(s, s->v, x, y)) <=
               texture_bound(s, s->v, x, y))) {
        texture_sample_note(s, x, y);
        test_note("error", error_of(&s->planes.u, at.u, texture_exact(s, s->u, x, y)));
        test_note("bound", texture_bound(s, s->u, x, y));
        test_note("error v", error_of(&s->planes.v, at.v, texture_exact(s, s->v, x, y)));
        test_note("bound v", texture_bound(s, s->v, x, y));
    }
}

static void divide_keeps_its_bound(void)
{
    uint32_t seed = 57;
    int32_t i, x, y;

    for (i = 0; i < TEST_COUNT(2400) && !test_failed(); i++) {
        struct texture_sample s;

        if (!texture_sample_make(&s, i, &seed))
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

static void draw(const struct texture_sample *s, const uint8_t order[3], int painter)
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
    const int64_t least = texture_least(c) * 4096, most = texture_most(c) * 4096;
    int64_t lo = place - near, hi = place + near;

    lo = lo < least ? least : lo > most ? most : lo;
    hi = hi < least ? least : hi > most ? most : hi;
    for (lo >>= 28, hi >>= 28; lo <= hi; lo++)
        if (((uint64_t)lo & 255) == texel)
            return true;
    return false;
}

/* Whether the line of a block is as near to the exact coordinate as fragment/texture.h says: a
 * quarter of what the coordinate changes by times what 1/w does, in 1/65536 of the lesser of its
 * ends. */
static bool line_is_near(const struct texture_sample *s, int64_t from, int64_t to, int64_t exact,
                         int32_t x, int32_t y)
{
    const struct etch_plane *const d = &s->planes.denominator;
    const int32_t start = x & ~INT32_C(15);
    const int64_t a = etch_ratio_at(d, start, y), b = etch_ratio_at(d, start + 16, y);
    const int64_t ratio = (a < b ? b - a : a - b) * 65536 / (a < b ? a : b) + 1;
    const int64_t change = to < from ? from - to : to - from;
    const int64_t error = from + (to - from) * (x - start) / 16 - exact;

    return ratio <= 65537 && (error < 0 ? -error : error) <= change / 4 * ratio / 65536 + 2;
}

/* One coordinate of a pixel: exact, or on the line between the ends of its block. */
static bool texel_ok(const struct texture_sample *s, const int32_t c[3], uint32_t texel,
                     bool by_blocks, int32_t x, int32_t y)
{
    const int64_t bound = texture_bound(s, c, x, y);

    if (!by_blocks)
        return is_near(c, texture_exact(s, c, x, y), bound, texel);
    const int32_t start = x & ~INT32_C(15);
    const int64_t from = texture_exact(s, c, start, y), to = texture_exact(s, c, start + 16, y);

    return is_near(c, from + (to - from) * (x - start) / 16, 4 * bound + (15 << 12), texel) &&
           line_is_near(s, from, to, texture_exact(s, c, x, y), x, y);
}

static void check_texels(const struct texture_sample *s, bool by_blocks)
{
    int32_t x, y;

    for (y = s->window.y0; y < s->window.y1; y++) {
        for (x = s->window.x0; x < s->window.x1; x++) {
            const uint16_t got = test_canvas_at(&canvas, x, y);

            if (!CHECK(oracle_triangle_covers(&s->exact, x, y)
                           ? texel_ok(s, s->u, got & 255, by_blocks, x, y) &&
                                 texel_ok(s, s->v, got >> 8, by_blocks, x, y)
                           : got == TEST_BACKGROUND))
                texture_sample_note(s, x, y);
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
        struct texture_sample s;

        if (!texture_sample_make(&s, i, &seed) || (s.w[0] == s.w[1] && s.w[0] == s.w[2]))
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
