/* tests/unit: depth and colour at the extremes: the nearest and the farthest value, equal ones, the
 * same triangle twice, every one of the 65,536 depths and colours over a whole triangle far from
 * its vertices. tests/EXTREMES.md lists what is where. */
#include "core/draw/exact.h"
#include "core/draw/shapes.h"
#include "core/draw/triangle.h"
#include "core/fragment/flat.h"
#include "core/fragment/gouraud.h"
#include "tests/harness/canvas.h"

void suite_extremes_depth(void);

static struct test_canvas canvas;

/* All over the plane and over the window, which is far from every vertex. */
static const int32_t corner_x[3] = {-8388608, 8388608, -8388608};
static const int32_t corner_y[3] = {-8388608, -8388608, 8388608};

static void paint(uint32_t z_q16, const uint8_t rgb[3], etch_triangle_painter *painter,
                  etch_kernel *kernel)
{
    struct etch_vertex v[3];
    const struct etch_vertex *const p[3] = {&v[0], &v[1], &v[2]};

    for (int i = 0; i < 3; i++)
        v[i] = (struct etch_vertex){corner_x[i] / 2 + 4000000,
                                    corner_y[i] / 2 + 4000000,
                                    z_q16,
                                    rgb[0],
                                    rgb[1],
                                    rgb[2],
                                    255};
    painter(&canvas.surface, p, kernel);
}

/* Every pixel of the window has this colour and depth. */
static bool all(uint16_t color, uint16_t depth)
{
    const struct etch_surface *s = &canvas.surface;

    for (int16_t y = s->window.y0; y < s->window.y1; y++)
        for (int16_t x = s->window.x0; x < s->window.x1; x++) {
            const size_t i = etch_surface_index(s, x, y);

            if (!CHECK_EQ(s->pixels[i], color) || !CHECK_EQ(s->depth[i], depth))
                return false;
        }
    return true;
}

static const uint8_t white[3] = {255, 255, 255}, black[3] = {0, 0, 0};

/* 0 is nearer than all but itself, 65,535 nearer than nothing. */
static void depth_at_0_and_65535(void)
{
    test_canvas_open(&canvas, (struct etch_rect){11000, 9000, 11006, 9005});
    paint(UINT32_C(0xFFFF0000), white, etch_triangle_flat_depth, etch_kernel_flat_less);
    CHECK(all(TEST_BACKGROUND, 65535));
    paint(UINT32_C(0xFFFF0000), white, etch_triangle_flat_depth, etch_kernel_flat_lequal);
    CHECK(all(0xFFFF, 65535));
    paint(0, black, etch_triangle_flat_depth, etch_kernel_flat_less);
    CHECK(all(0, 0));
    paint(0, white, etch_triangle_flat_depth, etch_kernel_flat_less);
    CHECK(all(0, 0));
    paint(0, white, etch_triangle_flat_depth, etch_kernel_flat_lequal);
    CHECK(all(0xFFFF, 0));
}

/* A plane drawn again, coplanar to the bit, loses every pixel with `less`, wins every one with
 * `lequal`, at every slope. */
static void coplanar_triangles_drawn_twice(void)
{
    static const uint32_t slope[][3] = {{0, 0, 0},
                                        {0, UINT32_C(0xFFFF0000), 0},
                                        {UINT32_C(0xFFFF0000), 0, 12345678},
                                        {1, 65535, 65536}};

    test_canvas_open(&canvas, (struct etch_rect){0, 0, 24, 18});
    for (int i = 0; i < 4; i++) {
        struct etch_vertex v[3] = {{-700, -900, slope[i][0], 255, 255, 255, 255},
                                   {9000, 300, slope[i][1], 255, 255, 255, 255},
                                   {1000, 7000, slope[i][2], 255, 255, 255, 255}};
        const struct etch_vertex *const p[3] = {&v[0], &v[1], &v[2]};
        const struct etch_vertex *const turned[3] = {&v[2], &v[1], &v[0]};
        uint32_t once;

        test_canvas_wipe(&canvas);
        etch_triangle_flat_depth(&canvas.surface, p, etch_kernel_flat_less);
        once = test_canvas_hash(&canvas);
        v[0].r = v[1].r = v[2].r = 0;
        etch_triangle_flat_depth(&canvas.surface, turned, etch_kernel_flat_less);
        CHECK_EQ(test_canvas_hash(&canvas), once);
        v[0].r = v[1].r = v[2].r = 255;
        etch_triangle_flat_depth(&canvas.surface, turned, etch_kernel_flat_lequal);
        CHECK_EQ(test_canvas_hash(&canvas), once);
        v[0].r = v[1].r = v[2].r = 0;
        etch_triangle_flat_depth(&canvas.surface, turned, etch_kernel_flat_lequal);
        for (int32_t k = 0; k < 24 * 18; k++)
            CHECK(test_canvas_at(&canvas, k % 24, k / 24) != 0xFFFF);
    }
}

/* From 0 to 65,535 within 1/256 px, and as steep the other way: no value outside 0 .. 65,535 wraps,
 * so a pixel is as near as one of the ends or between them, and left of the step it is exactly 0.
 * */
static void steepest_ramps(void)
{
    test_canvas_open(&canvas, (struct etch_rect){0, 0, 8, 4});
    for (int32_t at = 512; at < 1024; at += 32) {
        const struct etch_vertex v[3] = {{at, -60000, 0, 255, 255, 255, 255},
                                         {at + 1, -60000, UINT32_C(0xFFFF0000), 255, 255, 255, 255},
                                         {at, 60000, 0, 255, 255, 255, 255}};
        const struct etch_vertex *const p[3] = {&v[0], &v[1], &v[2]};
        const bool on = (at - 128) % 256 == 0; /* its left edge on centres */

        test_canvas_wipe(&canvas);
        etch_triangle_flat_depth(&canvas.surface, p, etch_kernel_flat_lequal);
        for (int32_t k = 0; k < 32; k++)
            if (test_canvas_drawn(&canvas, k % 8, k / 8))
                CHECK(on && canvas.surface.depth[etch_surface_index(
                                &canvas.surface, (int16_t)(k % 8), (int16_t)(k / 8))] == 0);
            else
                CHECK(!on || k % 8 != at / 256);
    }
}

/* A plane of one depth is that depth at every pixel. */
static void every_depth_is_constant(void)
{
    static etch_triangle_painter *const by[] = {etch_triangle_flat_depth,
                                                etch_triangle_gouraud_depth};
    static etch_kernel *const with[] = {etch_kernel_flat_lequal, etch_kernel_gouraud_lequal};

    test_canvas_open(&canvas, (struct etch_rect){11000, 9000, 11003, 9002});
    for (int32_t n = 0; n < TEST_COUNT(65536) && !test_failed(); n++) {
        const uint32_t z = (uint32_t)n * 25717 % 65536;

        etch_depth_clear(&canvas.surface, 65535);
        paint(z << 16, white, by[n & 1], with[n & 1]);
        CHECK(all(0xFFFF, (uint16_t)z));
    }
}

/* The 8-bit channel that is exactly n of `most` steps when it is rounded. */
static uint8_t channel(uint32_t n, uint32_t most)
{
    return (uint8_t)((n * 255 + most / 2) / most);
}

/* A triangle of one colour is that colour at every pixel, in each of the 65,536, flat, interpolated
 * and exact. */
static void every_color_is_constant(void)
{
    static etch_triangle_painter *const by[] = {etch_triangle_flat, etch_triangle_gouraud,
                                                etch_triangle_gouraud_exact};
    static etch_kernel *const with[] = {etch_kernel_flat, etch_kernel_gouraud,
                                        etch_kernel_gouraud_exact};

    test_canvas_open(&canvas, (struct etch_rect){11000, 9000, 11003, 9002});
    for (int32_t n = 0; n < TEST_COUNT(65536) && !test_failed(); n++) {
        const uint32_t c = (uint32_t)n * 25717 % 65536;
        const uint8_t rgb[3] = {channel(c >> 11, 31), channel(c >> 5 & 63, 63),
                                channel(c & 31, 31)};

        for (int i = 0; i < 3; i++) {
            etch_surface_clear(&canvas.surface, (uint16_t)~c);
            paint(0, rgb, by[i], with[i]);
            CHECK(all((uint16_t)c, 65535));
        }
    }
}

void suite_extremes_depth(void)
{
    RUN(depth_at_0_and_65535);
    RUN(coplanar_triangles_drawn_twice);
    RUN(steepest_ramps);
    RUN(every_depth_is_constant);
    RUN(every_color_is_constant);
}
