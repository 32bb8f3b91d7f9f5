/* tests/unit: dithered colours, against Bayer's matrix by its definition and exact rationals. */
#include "core/draw/dither.h"
#include "core/base/rgb565.h"
#include "tests/harness/canvas.h"
#include "tests/harness/sample.h"

void suite_dither(void);

static struct test_canvas canvas;
static int32_t pixels;

/* 0 .. 63: the bits of x ^ y and y, interleaved, the lowest first. */
static uint32_t bayer(int32_t x, int32_t y)
{
    uint32_t b = 0;

    for (int bit = 0; bit < 3; bit++)
        b = b << 2 | ((uint32_t)(x ^ y) >> bit & 1) << 1 | ((uint32_t)y >> bit & 1);
    return b;
}

/* Whether got = floor(v + t) for some v within 1/64 step of the exact value, t = (2 b + 1) / 128:
 * all times 255 * 128 area. And between the floor of the least and the ceiling of the greatest
 * vertex. */
static bool channel_ok(const struct test_sample *s, int32_t x, int32_t y, uint32_t got,
                       uint32_t full, const uint8_t c[3])
{
    const uint64_t area = (uint64_t)s->exact.area;
    const uint32_t value[3] = {c[0] * full, c[1] * full, c[2] * full};
    const struct wide exact = wide_scale(oracle_triangle_value(&s->exact, x, y, value), 128);
    const struct wide t = wide_scale(wide_product(area, 255), 2 * bayer(x, y) + 1);
    const struct wide up = wide_sum(exact, t), slack = wide_product(area, 255 * 2);
    uint32_t least = UINT32_MAX, greatest = 0;

    for (int i = 0; i < 3; i++) {
        least = value[i] / 255 < least ? value[i] / 255 : least;
        greatest = (value[i] + 254) / 255 > greatest ? (value[i] + 254) / 255 : greatest;
    }
    return got >= least && got <= greatest &&
           wide_at_most(wide_scale(wide_product(area, 255 * 128), got), wide_sum(up, slack)) &&
           wide_at_most(up, wide_sum(wide_scale(wide_product(area, 255 * 128), got + 1), slack));
}

static bool color_ok(const struct test_sample *s, int32_t x, int32_t y, uint16_t color)
{
    const struct etch_vertex *v = s->vertex;
    const uint8_t r[3] = {v[0].r, v[1].r, v[2].r}, g[3] = {v[0].g, v[1].g, v[2].g};
    const uint8_t b[3] = {v[0].b, v[1].b, v[2].b};

    return channel_ok(s, x, y, color >> 11, 31, r) && channel_ok(s, x, y, color >> 5 & 63, 63, g) &&
           channel_ok(s, x, y, color & 31, 31, b);
}

static void check_pixels(const struct test_sample *s, bool swapped)
{
    const struct etch_rect clip = canvas.surface.clip;

    for (int32_t y = clip.y0; y < clip.y1; y++) {
        for (int32_t x = clip.x0; x < clip.x1; x++) {
            const uint16_t memory = test_canvas_at(&canvas, x, y);

            if (!oracle_triangle_covers(&s->exact, x, y)) {
                CHECK_EQ(memory, TEST_BACKGROUND);
                continue;
            }
            pixels++;
            if (!CHECK(color_ok(s, x, y, swapped ? etch_rgb565_swap(memory) : memory)))
                test_sample_note(s, x, y);
        }
    }
    CHECK_ONCE(&canvas);
}

static void draw(const struct test_sample *s, etch_triangle_painter *painter, etch_kernel *kernel)
{
    const struct etch_vertex *const v[3] = {&s->vertex[0], &s->vertex[1], &s->vertex[2]};

    painter(&canvas.surface, v, kernel);
}

static void every_pixel_by_its_threshold(void)
{
    uint32_t seed = 71;

    for (int32_t i = 0; i < TEST_COUNT(4000) && !test_failed(); i++) {
        struct test_sample s;

        test_sample_make(&s, &canvas, i, &seed);
        draw(&s, etch_triangle_gouraud, etch_kernel_gouraud_dither);
        check_pixels(&s, false);
        test_canvas_wipe(&canvas);
        draw(&s, etch_triangle_gouraud, etch_kernel_gouraud_dither_swapped);
        check_pixels(&s, true);
    }
}

/* Depths are those of the plain kernels, and colours those of the kernel without depth. */
static void depth_kernels_are_the_same(void)
{
    static etch_kernel *const plain[2] = {etch_kernel_gouraud_less, etch_kernel_gouraud_lequal};
    static etch_kernel *const dithered[2][2] = {
        {etch_kernel_gouraud_dither_less, etch_kernel_gouraud_dither_lequal},
        {etch_kernel_gouraud_dither_less_swapped, etch_kernel_gouraud_dither_lequal_swapped}};
    static uint16_t depth[TEST_CANVAS_WORDS], color[TEST_CANVAS_WORDS];
    uint32_t seed = 72;

    for (int32_t i = 0; i < TEST_COUNT(2000) && !test_failed(); i++) {
        const struct etch_rect *w = &canvas.surface.window;
        struct test_sample s;
        int32_t n = 0, wrong = 0;

        test_sample_make(&s, &canvas, i, &seed);
        draw(&s, etch_triangle_gouraud, etch_kernel_gouraud_dither);
        for (int32_t y = w->y0; y < w->y1; y++)
            for (int32_t x = w->x0; x < w->x1; x++)
                color[n++] = test_canvas_at(&canvas, x, y);
        for (int k = 0; k < 4; k++) {
            const size_t stride = canvas.surface.stride;

            test_canvas_wipe(&canvas);
            draw(&s, etch_triangle_gouraud_depth, plain[k & 1]);
            for (size_t y = 0; y < 30; y++)
                for (size_t x = 0; x < 40; x++)
                    depth[y * 40 + x] = canvas.surface.depth[y * stride + x];
            test_canvas_wipe(&canvas);
            draw(&s, etch_triangle_gouraud_depth, dithered[k >> 1][k & 1]);
            for (size_t y = 0; y < 30; y++)
                for (size_t x = 0; x < 40; x++) {
                    const uint16_t z = canvas.surface.depth[y * stride + x];
                    const uint16_t c = canvas.surface.pixels[y * stride + x];

                    wrong += z != depth[y * 40 + x];
                    if (z != UINT16_MAX)
                        wrong += (k >> 1 ? etch_rgb565_swap(c) : c) != color[y * 40 + x];
                }
            if (!CHECK_EQ(wrong, 0))
                test_sample_note(&s, 0, 0);
        }
    }
}

/* One colour over four blocks of 8 x 8, every value of red and green: each block's mean is within
 * 1/128 of a step of the colour, and whole steps stay flat. */
static void blocks_have_the_mean(void)
{
    const struct etch_rect window = {8, 16, 24, 32};
    const struct etch_vertex corner[3] = {
        {0, 0, 0, 0, 0, 0, 255}, {64 * 256, 0, 0, 0, 0, 0, 255}, {0, 64 * 256, 0, 0, 0, 0, 255}};
    int32_t c, x, y;

    test_canvas_open(&canvas, window);
    for (c = 0; c < 256; c++) {
        struct etch_vertex colored = corner[0];
        const struct etch_vertex *const v[3] = {&colored, &corner[1], &corner[2]};
        int32_t red = 0, green = 0;

        colored.r = colored.g = (uint8_t)c;
        test_canvas_wipe(&canvas);
        etch_triangle_flat_dither(&canvas.surface, v, etch_kernel_gouraud_dither);
        for (y = 16; y < 32; y++)
            for (x = 8; x < 24; x++) {
                red += test_canvas_at(&canvas, x, y) >> 11;
                green += test_canvas_at(&canvas, x, y) >> 5 & 63;
                CHECK((test_canvas_at(&canvas, x, y) >> 11) * 255 >= c * 31 - 254);
            }
        /* |red / 256 - c 31 / 255| <= 1/128 */
        CHECK(red * 255 - c * 31 * 256 <= 510 && c * 31 * 256 - red * 255 <= 510);
        CHECK(green * 255 - c * 63 * 256 <= 510 && c * 63 * 256 - green * 255 <= 510);
    }
}

/* One colour with depth: the pixels of the painter without, the depths of a plain flat triangle. */
static void flat_with_depth(void)
{
    uint32_t seed = 73;

    for (int32_t i = 0; i < TEST_COUNT(500) && !test_failed(); i++) {
        static uint16_t depth[TEST_CANVAS_WORDS];
        struct test_sample s;
        int32_t wrong = 0;

        test_sample_make(&s, &canvas, i, &seed);
        for (int k = 1; k < 3; k++)
            s.vertex[k].r = s.vertex[0].r, s.vertex[k].g = s.vertex[0].g,
            s.vertex[k].b = s.vertex[0].b;
        draw(&s, etch_triangle_gouraud_depth, etch_kernel_gouraud_lequal);
        for (size_t at = 0; at < 30 * (size_t)canvas.surface.stride; at++)
            depth[at] = canvas.surface.depth[at];
        test_canvas_wipe(&canvas);
        draw(&s, etch_triangle_flat_depth_dither, etch_kernel_gouraud_dither_lequal);
        for (size_t at = 0; at < 30 * (size_t)canvas.surface.stride; at++)
            wrong += depth[at] != canvas.surface.depth[at];
        CHECK_EQ(wrong, 0);
        check_pixels(&s, false);
    }
}

void suite_dither(void)
{
    pixels = 0;
    RUN(every_pixel_by_its_threshold);
    RUN(depth_kernels_are_the_same);
    RUN(blocks_have_the_mean);
    RUN(flat_with_depth);
    test_print_count("", pixels, " pixels by Bayer's matrix and exact rationals");
}
