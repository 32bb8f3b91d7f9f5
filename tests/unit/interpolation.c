/* tests/unit: the bounds that interpolation promises for colour and depth, against exact rationals
 * on the snapped vertices, at every pixel of triangles of every kind. */
#include "core/draw/triangle.h"
#include "core/fragment/flat.h"
#include "core/fragment/gouraud.h"
#include "tests/harness/canvas.h"
#include "tests/harness/sample.h"

void suite_interpolation(void);

#define FAR UINT32_C(0xFFFF0000) /* depth 65535.0 */

static struct test_canvas canvas;
static int32_t pixels;

/* The largest errors seen, in 2^-17 of a step or unit. */
static uint32_t worst_color, worst_depth;

/* Whether the error is within `bound` / 2^17; keeps the largest in *worst. */
static bool near_enough(const struct test_sample *s, uint32_t got, struct wide value, uint32_t unit,
                        uint32_t bound, uint32_t *worst)
{
    const uint64_t area = (uint64_t)s->exact.area;

    if (!test_sample_within(got, value, area, unit, bound))
        return false;
    while (!test_sample_within(got, value, area, unit, *worst))
        *worst += 16;
    return true;
}

/* One channel: within the bound and between the rounded least and greatest vertex. */
static bool channel_ok(const struct test_sample *s, int32_t x, int32_t y, uint32_t got,
                       uint32_t full, const uint8_t c[3])
{
    const uint32_t value[3] = {c[0] * full, c[1] * full, c[2] * full};
    uint32_t least = UINT32_MAX, greatest = 0;
    int i;

    for (i = 0; i < 3; i++) {
        const uint32_t rounded = (2 * value[i] + 255) / 510;

        least = rounded < least ? rounded : least;
        greatest = rounded > greatest ? rounded : greatest;
    }
    return got >= least && got <= greatest &&
           near_enough(s, got, oracle_triangle_value(&s->exact, x, y, value), 255, TEST_NEAR_BOUND,
                       &worst_color);
}

static bool color_ok(const struct test_sample *s, int32_t x, int32_t y, uint16_t color)
{
    const struct etch_vertex *v = s->vertex;
    const uint8_t r[3] = {v[0].r, v[1].r, v[2].r}, g[3] = {v[0].g, v[1].g, v[2].g};
    const uint8_t b[3] = {v[0].b, v[1].b, v[2].b};

    return channel_ok(s, x, y, color >> 11, 31, r) && channel_ok(s, x, y, color >> 5 & 63, 63, g) &&
           channel_ok(s, x, y, color & 31, 31, b);
}

static bool depth_ok(const struct test_sample *s, int32_t x, int32_t y, uint16_t depth)
{
    const struct etch_vertex *v = s->vertex;
    const uint32_t z[3] = {v[0].z_q16, v[1].z_q16, v[2].z_q16};
    const uint32_t sum = (uint32_t)(x + y);
    uint32_t ignored = UINT32_MAX;

    return near_enough(s, depth, oracle_triangle_value(&s->exact, x, y, z), 65536,
                       sum <= 2046 ? TEST_NEAR_BOUND : 65536 + sum + 1,
                       sum <= 2046 ? &worst_depth : &ignored);
}

/* Colour and depth of every covered pixel; the others untouched. */
static void check_pixels(const struct test_sample *s)
{
    const struct etch_rect clip = canvas.surface.clip;
    int32_t x, y;

    for (y = clip.y0; y < clip.y1; y++) {
        for (x = clip.x0; x < clip.x1; x++) {
            const size_t at = etch_surface_index(&canvas.surface, (int16_t)x, (int16_t)y);
            const uint16_t color = canvas.surface.pixels[at], depth = canvas.surface.depth[at];

            if (!oracle_triangle_covers(&s->exact, x, y)) {
                CHECK(color == TEST_BACKGROUND && depth == UINT16_MAX);
                continue;
            }
            pixels++;
            if (!CHECK(color_ok(s, x, y, color)) || !CHECK(depth_ok(s, x, y, depth)))
                test_sample_note(s, x, y);
        }
    }
    CHECK_ONCE(&canvas);
}

static void draw(const struct test_sample *s, const uint8_t order[3])
{
    const struct etch_vertex *const v[3] = {&s->vertex[order[0]], &s->vertex[order[1]],
                                            &s->vertex[order[2]]};

    etch_triangle_gouraud_depth(&canvas.surface, v, etch_kernel_gouraud_lequal);
}

static void color_and_depth_keep_their_bounds(void)
{
    uint32_t seed = 41;
    int32_t i;

    for (i = 0; i < TEST_COUNT(20000) && !test_failed(); i++) {
        struct test_sample s;
        uint32_t hash;
        int k;

        test_sample_make(&s, &canvas, i, &seed);
        draw(&s, test_orders[0]);
        check_pixels(&s);
        hash = test_canvas_hash(&canvas);
        for (k = 1; k < 6; k++) { /* the order of the vertices changes no value */
            test_canvas_wipe(&canvas);
            draw(&s, test_orders[k]);
            if (!CHECK_EQ(test_canvas_hash(&canvas), hash))
                test_sample_note(&s, 0, 0);
        }
    }
}

/* Slivers over a pixel centre, whose slopes are the steepest: where short cuts show first. */
static void slivers_keep_their_bounds(void)
{
    uint32_t seed = 46;
    int32_t i;

    for (i = 0; i < TEST_COUNT(100000) && !test_failed(); i++) {
        struct test_sample s;
        int k;

        test_sample_make_kind(&s, &canvas, TEST_TRIANGLE_sliver, i, &seed);
        for (k = 0; k < 3; k++) {
            s.vertex[k].r = (uint8_t)(i >> (2 + k) & 1 ? 255 : 0);
            s.vertex[k].g = (uint8_t)(255 - s.vertex[k].r);
        }
        draw(&s, test_orders[0]);
        check_pixels(&s);
    }
}

/* A near triangle whose gradient, brought into 31 bits, rounds down to -2^31. */
static void depth_with_a_gradient_at_the_end_of_its_range(void)
{
    static const int32_t x[3] = {2357, -118502, 12572}, y[3] = {3916, -22554, -114616};
    static const uint32_t z_q16[3] = {0, UINT32_C(0xFFFF0000), UINT32_C(0xFFFF0000)};
    const struct etch_rect window = {0, 0, 40, 30};
    struct test_sample s;
    int i;

    oracle_triangle_make(&s.exact, x, y);
    for (i = 0; i < 3; i++) {
        const struct etch_vertex v = {x[i], y[i], z_q16[i], 0, 0, 0, 255};

        s.vertex[i] = v;
    }
    test_canvas_open(&canvas, window);
    draw(&s, test_orders[0]);
    check_pixels(&s);
}

/* Depths beyond 65535.0, up to the last one that the type holds, count as 65535.0: bounds hold, and
 * the painters that take depths draw what they draw of the depths so clamped. */
static void depths_beyond_far_are_far(void)
{
    static const uint32_t beyond[] = {FAR + 1,      FAR + 0x7FFF, FAR + 0x8000,
                                      FAR + 0x8001, FAR + 0xFFFE, UINT32_MAX};
    uint32_t seed = 47;
    int32_t i;

    for (i = 0; i < TEST_COUNT(20000) && !test_failed(); i++) {
        struct test_sample s;
        struct etch_vertex given[3];
        const struct etch_vertex *const v[3] = {&given[0], &given[1], &given[2]};
        uint32_t hash;
        int k;

        test_sample_make(&s, &canvas, i, &seed);
        for (k = 0; k < 3; k++) {
            const uint32_t bits = test_random(&seed);

            if (i % 3 == 0 || bits % 2 == 0)
                s.vertex[k].z_q16 = FAR;
            given[k] = s.vertex[k];
            if (given[k].z_q16 == FAR)
                given[k].z_q16 = beyond[bits / 2 % 6];
        }
        etch_triangle_gouraud_depth(&canvas.surface, v, etch_kernel_gouraud_lequal);
        check_pixels(&s);
        test_canvas_wipe(&canvas);
        etch_triangle_flat_depth(&canvas.surface, v, etch_kernel_flat_lequal);
        hash = test_canvas_hash(&canvas);
        test_canvas_wipe(&canvas);
        for (k = 0; k < 3; k++)
            given[k].z_q16 = s.vertex[k].z_q16;
        etch_triangle_flat_depth(&canvas.surface, v, etch_kernel_flat_lequal);
        if (!CHECK_EQ(test_canvas_hash(&canvas), hash))
            test_sample_note(&s, 0, 0);
    }
}

/* The colour kernel without depth gives the same colours. */
static void color_without_depth_is_the_same(void)
{
    uint32_t seed = 42;
    int32_t i, x, y;

    for (i = 0; i < TEST_COUNT(2000) && !test_failed(); i++) {
        static uint16_t first[64 * 48];
        struct test_sample s;
        const struct etch_vertex *const v[3] = {&s.vertex[0], &s.vertex[1], &s.vertex[2]};
        const struct etch_rect *clip = &canvas.surface.clip;
        int32_t wrong = 0, n = 0;

        test_sample_make(&s, &canvas, i, &seed);
        draw(&s, test_orders[0]);
        for (y = clip->y0; y < clip->y1; y++)
            for (x = clip->x0; x < clip->x1; x++)
                first[n++] = test_canvas_at(&canvas, x, y);
        test_canvas_wipe(&canvas);
        etch_triangle_gouraud(&canvas.surface, v, etch_kernel_gouraud);
        n = 0;
        for (y = clip->y0; y < clip->y1; y++)
            for (x = clip->x0; x < clip->x1; x++)
                wrong += first[n++] != test_canvas_at(&canvas, x, y) ||
                         canvas.surface.depth[etch_surface_index(&canvas.surface, (int16_t)x,
                                                                 (int16_t)y)] != UINT16_MAX;
        if (!CHECK_EQ(wrong, 0))
            test_sample_note(&s, 0, 0);
    }
}

/* Equal values at the vertices give exactly the rounded value at every pixel. */
static void constants_stay_constant(void)
{
    uint32_t seed = 43;
    int32_t i, x, y;

    for (i = 0; i < TEST_COUNT(5000) && !test_failed(); i++) {
        const struct etch_rect *clip = &canvas.surface.clip;
        struct test_sample s;
        uint16_t color, depth;
        int32_t wrong = 0;
        int k;

        test_sample_make(&s, &canvas, i, &seed);
        for (k = 1; k < 3; k++) {
            s.vertex[k].r = s.vertex[0].r;
            s.vertex[k].g = s.vertex[0].g;
            s.vertex[k].b = s.vertex[0].b;
            s.vertex[k].z_q16 = s.vertex[0].z_q16;
        }
        color = (uint16_t)((2 * 31 * s.vertex[0].r + 255) / 510 << 11 |
                           (2 * 63 * s.vertex[0].g + 255) / 510 << 5 |
                           (2 * 31 * s.vertex[0].b + 255) / 510);
        depth = (uint16_t)((s.vertex[0].z_q16 + 32768) >> 16);
        draw(&s, test_orders[i % 6]);
        for (y = clip->y0; y < clip->y1; y++) {
            for (x = clip->x0; x < clip->x1; x++) {
                const size_t at = etch_surface_index(&canvas.surface, (int16_t)x, (int16_t)y);

                wrong += oracle_triangle_covers(&s.exact, x, y) &&
                         (canvas.surface.pixels[at] != color || canvas.surface.depth[at] != depth);
            }
        }
        if (!CHECK_EQ(wrong, 0))
            test_sample_note(&s, 0, 0);
    }
}

void suite_interpolation(void)
{
    pixels = 0;
    worst_color = 65536;
    worst_depth = 65536;
    RUN(color_and_depth_keep_their_bounds);
    RUN(slivers_keep_their_bounds);
    RUN(depth_with_a_gradient_at_the_end_of_its_range);
    RUN(depths_beyond_far_are_far);
    RUN(color_without_depth_is_the_same);
    RUN(constants_stay_constant);
    test_print_count("", pixels, " pixels against exact rationals, none beyond its bound");
    test_print_count("largest error of colour 1/2 + ", (worst_color - 65536 + 127) / 128,
                     "/1024 step, allowed 16");
    test_print_count("largest error of depth 1/2 + ", (worst_depth - 65536 + 127) / 128,
                     "/1024 unit where x + y <= 2046, allowed 16");
}
