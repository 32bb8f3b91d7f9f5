/* tests/unit: the small Gouraud triangles keep the bounds of the precise mode for colour and depth
 * against exact rationals, at every pixel of triangles of every kind, in any vertex order; and the
 * small kernels write what the fast ones do. */
#include "core/draw/triangle_small.h"
#include "core/fragment/gouraud_small.h"
#include "tests/harness/canvas.h"
#include "tests/harness/sample.h"

void suite_interpolation_small(void);

static struct test_canvas canvas;
static int32_t pixels;

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
           test_sample_within(got, oracle_triangle_value(&s->exact, x, y, value),
                              (uint64_t)s->exact.area, 255, TEST_NEAR_BOUND);
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

    return test_sample_within(depth, oracle_triangle_value(&s->exact, x, y, z),
                              (uint64_t)s->exact.area, 65536,
                              sum <= 2046 ? TEST_NEAR_BOUND : 65536 + sum + 1);
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
            if (depth == UINT16_MAX && color == TEST_BACKGROUND) { /* not LESS than the clear */
                CHECK(depth_ok(s, x, y, depth));
                continue;
            }
            pixels++;
            if (!CHECK(color_ok(s, x, y, color)) || !CHECK(depth_ok(s, x, y, depth)))
                test_sample_note(s, x, y);
        }
    }
    CHECK_ONCE(&canvas);
}

static void draw(const struct test_sample *s, const uint8_t order[3],
                 etch_triangle_painter *painter, etch_kernel *kernel)
{
    const struct etch_vertex *const v[3] = {&s->vertex[order[0]], &s->vertex[order[1]],
                                            &s->vertex[order[2]]};

    painter(&canvas.surface, v, kernel);
}

static void bounds_hold(void)
{
    uint32_t seed = 94;
    int32_t i;

    for (i = 0; i < TEST_COUNT(20000) && !test_failed(); i++) {
        struct test_sample s;
        uint32_t hash;

        test_sample_make(&s, &canvas, i, &seed);
        draw(&s, test_orders[0], etch_triangle_gouraud_depth_small, etch_kernel_gouraud_less_small);
        check_pixels(&s);
        hash = test_canvas_hash(&canvas);
        test_canvas_wipe(&canvas);
        draw(&s, test_orders[1 + i % 5], etch_triangle_gouraud_depth_small,
             etch_kernel_gouraud_less_small);
        if (!CHECK_EQ(test_canvas_hash(&canvas), hash))
            test_sample_note(&s, 0, 0);
    }
}

/* Both small kernels against the fast ones, on the same planes. */
static void kernels_write_the_same(void)
{
    uint32_t seed = 95;
    int32_t i;

    for (i = 0; i < TEST_COUNT(5000) && !test_failed(); i++) {
        struct test_sample s;
        uint32_t hash;
        int k;

        test_sample_make(&s, &canvas, i, &seed);
        draw(&s, test_orders[0], etch_triangle_gouraud_small, etch_kernel_gouraud);
        hash = test_canvas_hash(&canvas);
        test_canvas_wipe(&canvas);
        draw(&s, test_orders[0], etch_triangle_gouraud_small, etch_kernel_gouraud_small);
        CHECK_EQ(test_canvas_hash(&canvas), hash);
        CHECK_ONCE(&canvas);
        for (k = 0, hash = 0; k < 2; k++) { /* depths on both sides of the triangle's */
            const uint32_t first = seed;
            uint32_t plane = first;
            int32_t x, y;

            test_canvas_wipe(&canvas);
            for (y = canvas.surface.clip.y0; y < canvas.surface.clip.y1; y++)
                for (x = canvas.surface.clip.x0; x < canvas.surface.clip.x1; x++)
                    canvas.surface
                        .depth[etch_surface_index(&canvas.surface, (int16_t)x, (int16_t)y)] =
                        (uint16_t)(test_random(&plane) >> 16);
            draw(&s, test_orders[0], etch_triangle_gouraud_depth_small,
                 k == 0 ? etch_kernel_gouraud_less : etch_kernel_gouraud_less_small);
            if (k == 0)
                hash = test_canvas_hash(&canvas);
            else if (!CHECK_EQ(test_canvas_hash(&canvas), hash))
                test_sample_note(&s, 0, 0);
            CHECK_INSIDE(&canvas);
        }
    }
}

void suite_interpolation_small(void)
{
    pixels = 0;
    RUN(bounds_hold);
    RUN(kernels_write_the_same);
    test_print_count("", pixels, " pixels against exact rationals, none beyond its bound");
}
