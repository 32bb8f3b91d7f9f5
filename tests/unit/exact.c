/* tests/unit: the exact mode. Every colour and depth is the exact rational rounded half up, at
 * every pixel of triangles of every kind. */
#include "core/draw/exact.h"
#include "core/base/rgb565.h"
#include "tests/harness/canvas.h"
#include "tests/harness/sample.h"

void suite_exact(void);

static struct test_canvas canvas;
static int32_t pixels;

/* Whether got = floor(value / (area unit) + 1/2); value from oracle_triangle_value, unit even. */
static bool is_rounded(const struct test_sample *s, uint32_t got, struct wide value, uint32_t unit)
{
    const uint64_t area = (uint64_t)s->exact.area;
    const struct wide up = wide_sum(value, wide_product(area, unit / 2));

    return wide_at_most(wide_scale(wide_product(area, unit), got), up) &&
           !wide_at_most(wide_scale(wide_product(area, unit), got + 1), up);
}

static bool channel_ok(const struct test_sample *s, int32_t x, int32_t y, uint32_t got,
                       uint32_t full, const uint8_t c[3])
{
    const uint32_t value[3] = {2 * full * c[0], 2 * full * c[1], 2 * full * c[2]};

    return is_rounded(s, got, oracle_triangle_value(&s->exact, x, y, value), 510);
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

    return is_rounded(s, depth, oracle_triangle_value(&s->exact, x, y, z), 65536);
}

/* Colour, where `colored`, and depth, where `deep`, of every covered pixel; the others untouched.
 */
static void check_pixels(const struct test_sample *s, bool colored, bool deep, uint16_t swap)
{
    const struct etch_rect clip = canvas.surface.clip;

    for (int32_t y = clip.y0; y < clip.y1; y++) {
        for (int32_t x = clip.x0; x < clip.x1; x++) {
            const size_t at = etch_surface_index(&canvas.surface, (int16_t)x, (int16_t)y);
            const uint16_t memory = canvas.surface.pixels[at], depth = canvas.surface.depth[at];
            const uint16_t color = swap ? etch_rgb565_swap(memory) : memory;

            if (!oracle_triangle_covers(&s->exact, x, y)) {
                CHECK(memory == TEST_BACKGROUND && depth == UINT16_MAX);
                continue;
            }
            pixels++;
            if (!CHECK(!colored || color_ok(s, x, y, color)) ||
                !CHECK(deep ? depth_ok(s, x, y, depth) : depth == UINT16_MAX))
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

/* Slivers are where slopes are steepest, and where the precise planes change from way to way. */
static void check_sample(int32_t i, uint32_t *seed, bool sliver)
{
    struct test_sample s;
    const uint8_t *const order = test_orders[i % 6];

    if (sliver)
        test_sample_make_kind(&s, &canvas, TEST_TRIANGLE_sliver, i, seed);
    else
        test_sample_make(&s, &canvas, i, seed);
    draw(&s, order, etch_triangle_gouraud_depth_exact, etch_kernel_gouraud_exact_lequal);
    check_pixels(&s, true, true, false);
    test_canvas_wipe(&canvas);
    draw(&s, order, etch_triangle_gouraud_exact, etch_kernel_gouraud_exact);
    check_pixels(&s, true, false, false);
    test_canvas_wipe(&canvas);
    draw(&s, order, etch_triangle_flat_depth_exact, etch_kernel_flat_exact_lequal);
    check_pixels(&s, false, true, false);
}

static void every_pixel_is_rounded_half_up(void)
{
    uint32_t seed = 61;

    for (int32_t i = 0; i < TEST_COUNT(6000) && !test_failed(); i++)
        check_sample(i, &seed, false);
}

static void slivers_too(void)
{
    uint32_t seed = 62;

    for (int32_t i = 0; i < TEST_COUNT(20000) && !test_failed(); i++)
        check_sample(i, &seed, true);
}

/* From 127 to 128 over two pixels: 127.5 is 15.5 of 31 and 31.5 of 63, and goes up. Depth likewise.
 */
static void ties_go_up(void)
{
    static const int32_t x[3] = {128, 128 + 512, 128}, y[3] = {128, 128, 128 + 512};
    static const uint8_t c[3] = {127, 128, 127};
    const struct etch_rect window = {0, 0, 4, 4};
    struct test_sample s;

    oracle_triangle_make(&s.exact, x, y);
    for (int i = 0; i < 3; i++)
        s.vertex[i] = (struct etch_vertex){x[i], y[i], (uint32_t)c[i] << 16, c[i], c[i], c[i], 255};
    test_canvas_open(&canvas, window);
    draw(&s, test_orders[0], etch_triangle_gouraud_depth_exact, etch_kernel_gouraud_exact_less);
    check_pixels(&s, true, true, false);
    CHECK_EQ(test_canvas_at(&canvas, 1, 0), 16 << 11 | 32 << 5 | 16);
    CHECK_EQ(canvas.surface.depth[etch_surface_index(&canvas.surface, 1, 0)], 128);
}

/* The last depths that the type holds, seen where planes are least exact. */
static void depths_at_the_end_of_their_range(void)
{
    static const uint32_t z_q16[] = {0, 1, 0x7FFF, 0x8000, UINT32_C(0xFFFF0000), UINT32_MAX};
    uint32_t seed = 63;

    for (int32_t i = 0; i < TEST_COUNT(3000) && !test_failed(); i++) {
        struct test_sample s;

        test_sample_make(&s, &canvas, i, &seed);
        for (int k = 0; k < 3; k++)
            s.vertex[k].z_q16 = z_q16[test_range(&seed, 0, 5)];
        draw(&s, test_orders[0], etch_triangle_flat_depth_exact, etch_kernel_flat_exact_lequal);
        for (int k = 0; k < 3; k++) /* above 65535.0 counts as that */
            if (s.vertex[k].z_q16 > UINT32_C(0xFFFF0000))
                s.vertex[k].z_q16 = UINT32_C(0xFFFF0000);
        check_pixels(&s, false, true, false);
    }
}

/* LESS and LEQUAL as promised; bytes swapped; a clip changes no pixel. */
static void tests_clips_and_bytes(void)
{
    uint32_t seed = 64;

    for (int32_t i = 0; i < TEST_COUNT(2000) && !test_failed(); i++) {
        struct test_sample s;
        uint32_t hash;

        test_sample_make(&s, &canvas, i, &seed);
        draw(&s, test_orders[0], etch_triangle_gouraud_depth_exact,
             etch_kernel_gouraud_exact_less_swapped);
        draw(&s, test_orders[1], etch_triangle_flat_depth_exact_swapped,
             etch_kernel_flat_exact_less); /* changes nothing: nothing is nearer */
        hash = test_canvas_hash(&canvas);
        for (int32_t y = 0; y < canvas.surface.window.y1 - canvas.surface.window.y0; y++) {
            const uint32_t at = (uint32_t)y * canvas.surface.stride;

            CHECK(canvas.surface.depth[at] == UINT16_MAX ||
                  canvas.surface.pixels[at] != TEST_BACKGROUND);
        }
        for (int32_t x = 0; x < 40; x++)
            for (int32_t y = 0; y < 30; y++) {
                const size_t at = (size_t)y * canvas.surface.stride + (size_t)x;
                const int32_t fx = x + canvas.surface.window.x0, fy = y + canvas.surface.window.y0;

                if (oracle_triangle_covers(&s.exact, fx, fy) &&
                    canvas.surface.depth[at] != UINT16_MAX)
                    CHECK(color_ok(&s, fx, fy, etch_rgb565_swap(canvas.surface.pixels[at])));
            }
        test_canvas_wipe(&canvas);
        for (int k = 0; k < 4; k++) { /* in quarters */
            const struct etch_rect w = canvas.surface.window;
            const int16_t mx = (int16_t)(w.x0 + 17), my = (int16_t)(w.y0 + 11);
            const struct etch_rect part = {k & 1 ? mx : w.x0, k & 2 ? my : w.y0, k & 1 ? w.x1 : mx,
                                           k & 2 ? w.y1 : my};

            etch_surface_clip(&canvas.surface, part);
            draw(&s, test_orders[2], etch_triangle_gouraud_depth_exact,
                 etch_kernel_gouraud_exact_lequal_swapped);
        }
        etch_surface_clip(&canvas.surface, canvas.surface.window);
        /* depth 65535 passes LEQUAL and not LESS: then the colours differ there only */
        if (s.vertex[0].z_q16 < UINT32_C(0xFF000000) && s.vertex[1].z_q16 < UINT32_C(0xFF000000) &&
            s.vertex[2].z_q16 < UINT32_C(0xFF000000))
            CHECK_EQ(test_canvas_hash(&canvas), hash);
    }
}

void suite_exact(void)
{
    pixels = 0;
    RUN(every_pixel_is_rounded_half_up);
    RUN(slivers_too);
    RUN(ties_go_up);
    RUN(depths_at_the_end_of_their_range);
    RUN(tests_clips_and_bytes);
    test_print_count("", pixels, " pixels are exact rationals rounded half up");
}
