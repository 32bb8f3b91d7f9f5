/* tests/unit: fragment kernels, shipped ones and those of the one-line macro: depth tests and byte
 * order. */
#include "core/base/rgb565.h"
#include "core/draw/triangle.h"
#include "core/fragment/flat.h"
#include "core/fragment/flat_shader.h"
#include "core/fragment/gouraud.h"
#include "core/fragment/gouraud_shader.h"
#include "tests/harness/canvas.h"
#include "tests/harness/shapes.h"
#include "tests/oracle/triangle.h"

void suite_kernel(void);

static const struct etch_rect frame = {0, 0, 40, 30};
static struct test_canvas canvas, other;

/* ---- kernels that are not shipped, by one line each -------------------------------------------
 */

#define ALL_TESTS(X)                                                                               \
    X(never, false)                                                                                \
    X(less, d < s)                                                                                 \
    X(equal, d == s)                                                                               \
    X(lequal, d <= s)                                                                              \
    X(greater, d > s)                                                                              \
    X(notequal, d != s)                                                                            \
    X(gequal, d >= s)                                                                              \
    X(always, true)

#define USER_KERNELS(test, condition)                                                              \
    etch_kernel user_##test##_writes, user_##test##_keeps;                                         \
    ETCH_KERNEL(user_##test##_writes, etch_gouraud_shader, etch_depth_##test, true)                \
    ETCH_KERNEL(user_##test##_keeps, etch_gouraud_shader, etch_depth_##test, false)                \
    static bool expect_##test(uint16_t d, uint16_t s)                                              \
    {                                                                                              \
        (void)d, (void)s;                                                                          \
        return condition;                                                                          \
    }
ALL_TESTS(USER_KERNELS)

static const struct {
    etch_kernel *writes, *keeps;
    bool (*expect)(uint16_t d, uint16_t s);
} depth_kernels[] = {
#define ROW(test, condition) {user_##test##_writes, user_##test##_keeps, expect_##test},
    ALL_TESTS(ROW)};

static void random_vertices(struct etch_vertex v[3], enum test_triangle_kind kind, uint32_t *seed)
{
    struct test_triangle t;
    int i;

    test_triangle_make(&t, kind, frame, seed);
    for (i = 0; i < 3; i++) {
        const uint32_t bits = test_random(seed);

        v[i].x_q8 = t.x[i];
        v[i].y_q8 = t.y[i];
        v[i].z_q16 = test_random(seed) >> 13 << 10; /* coarse, so that depths meet */
        v[i].r = (uint8_t)(bits & 255);
        v[i].g = (uint8_t)(bits >> 8 & 255);
        v[i].b = (uint8_t)(bits >> 16 & 255);
        v[i].a = 255;
    }
}

/* The pixels of a triangle, by the oracle: its own colours may equal the background. */
static struct oracle_triangle outline_of(const struct etch_vertex v[3])
{
    const int32_t x[3] = {v[0].x_q8, v[1].x_q8, v[2].x_q8};
    const int32_t y[3] = {v[0].y_q8, v[1].y_q8, v[2].y_q8};
    struct oracle_triangle t;

    oracle_triangle_make(&t, x, y);
    return t;
}

typedef void painter(const struct etch_surface *s, const struct etch_vertex *const v[3],
                     etch_kernel *kernel);

static void paint(painter *paint_triangle, struct test_canvas *c, const struct etch_vertex v[3],
                  etch_kernel *kernel)
{
    const struct etch_vertex *const p[3] = {&v[0], &v[1], &v[2]};

    paint_triangle(&c->surface, p, kernel);
}

/* The same depths near those of the triangle on both canvases: equal, one off, or anything. */
static void seed_depths(const struct test_canvas *from, uint32_t seed)
{
    const struct etch_rect w = canvas.surface.window;
    int32_t x, y;

    for (y = w.y0; y < w.y1; y++) {
        for (x = w.x0; x < w.x1; x++) {
            const size_t at = etch_surface_index(&canvas.surface, (int16_t)x, (int16_t)y);
            const uint16_t d = from->surface.depth[at];
            const uint32_t bits = test_random(&seed);
            const int32_t moved = d + (int32_t)(bits % 3) - 1;

            canvas.surface.depth[at] = (uint16_t)(bits & 64       ? (int32_t)(bits >> 16)
                                                  : moved < 0     ? 0
                                                  : moved > 65535 ? 65535
                                                                  : moved);
        }
    }
}

/* Draws v over the prepared canvas by `kernel` and compares with what `expect` makes of the
 * triangle's own colours and depths, which `other` holds. */
static void compare_depth_kernel(painter *paint_triangle, const struct etch_vertex v[3],
                                 etch_kernel *kernel, bool (*expect)(uint16_t, uint16_t),
                                 bool writes, uint32_t seed)
{
    const struct etch_rect w = canvas.surface.window;
    const struct oracle_triangle t = outline_of(v);
    static uint16_t before[40 * 30];
    int32_t x, y, wrong = 0, n = 0;

    test_canvas_wipe(&canvas);
    seed_depths(&other, seed);
    for (y = w.y0; y < w.y1; y++)
        for (x = w.x0; x < w.x1; x++)
            before[n++] =
                canvas.surface.depth[etch_surface_index(&canvas.surface, (int16_t)x, (int16_t)y)];
    paint(paint_triangle, &canvas, v, kernel);
    n = 0;
    for (y = w.y0; y < w.y1; y++) {
        for (x = w.x0; x < w.x1; x++) {
            const size_t at = etch_surface_index(&canvas.surface, (int16_t)x, (int16_t)y);
            const bool drawn = oracle_triangle_covers(&t, x, y) &&
                               expect(other.surface.depth[at], before[n]);

            wrong += canvas.surface.pixels[at] !=
                     (drawn ? other.surface.pixels[at] : TEST_BACKGROUND);
            wrong += canvas.surface.depth[at] !=
                     (drawn && writes ? other.surface.depth[at] : before[n]);
            n++;
        }
    }
    CHECK_EQ(wrong, 0);
    CHECK_ONCE(&canvas);
}

/* `other` gets the triangle alone, its colours and depths over depth 65535. */
static void draw_alone(painter *paint_triangle, const struct etch_vertex v[3], etch_kernel *kernel)
{
    test_canvas_open(&canvas, frame);
    test_canvas_open(&other, frame);
    paint(paint_triangle, &other, v, kernel);
}

static void every_depth_test_by_the_macro(void)
{
    uint32_t seed = 51;
    int32_t i;

    for (i = 0; i < TEST_COUNT(4000) && !test_failed(); i++) {
        const int k = i % 8;
        struct etch_vertex v[3];

        random_vertices(v, (enum test_triangle_kind)(i / 8 % TEST_TRIANGLE_KINDS), &seed);
        draw_alone(etch_triangle_gouraud_depth, v, user_always_writes);
        compare_depth_kernel(etch_triangle_gouraud_depth, v, depth_kernels[k].writes,
                             depth_kernels[k].expect, true, seed);
        compare_depth_kernel(etch_triangle_gouraud_depth, v, depth_kernels[k].keeps,
                             depth_kernels[k].expect, false, seed);
    }
}

/* The shipped kernels are those tests. */
static void shipped_less_and_lequal(void)
{
    uint32_t seed = 52;
    int32_t i;

    for (i = 0; i < TEST_COUNT(2000) && !test_failed(); i++) {
        struct etch_vertex v[3];

        random_vertices(v, (enum test_triangle_kind)(i % TEST_TRIANGLE_KINDS), &seed);
        draw_alone(etch_triangle_gouraud_depth, v, user_always_writes);
        compare_depth_kernel(etch_triangle_gouraud_depth, v, etch_kernel_gouraud_less, expect_less,
                             true, seed);
        compare_depth_kernel(etch_triangle_gouraud_depth, v, etch_kernel_gouraud_lequal,
                             expect_lequal, true, seed);
        draw_alone(etch_triangle_flat_depth, v, etch_kernel_flat_lequal);
        compare_depth_kernel(etch_triangle_flat_depth, v, etch_kernel_flat_less, expect_less, true,
                             seed);
        compare_depth_kernel(etch_triangle_flat_depth, v, etch_kernel_flat_lequal, expect_lequal,
                             true, seed);
    }
}

/* The contract of DESIGN: the second time, LESS changes nothing and LEQUAL redraws every pixel.
 * Another colour the second time, the same depths. */
static void same_triangle_twice(void)
{
    uint32_t seed = 53;
    int32_t i, x, y;

    for (i = 0; i < TEST_COUNT(5000) && !test_failed(); i++) {
        const struct etch_rect w = frame;
        struct etch_vertex v[3];
        uint32_t once;
        int32_t wrong = 0;
        int k;

        random_vertices(v, (enum test_triangle_kind)(i % TEST_TRIANGLE_KINDS), &seed);
        for (k = 0; k < 3; k++)
            v[k].r = 0;
        test_canvas_open(&canvas, frame);
        paint(etch_triangle_gouraud_depth, &canvas, v, etch_kernel_gouraud_lequal);
        once = test_canvas_hash(&canvas);
        for (k = 0; k < 3; k++)
            v[k].r = 255;
        paint(etch_triangle_gouraud_depth, &canvas, v, etch_kernel_gouraud_less);
        CHECK_EQ(test_canvas_hash(&canvas), once);
        test_canvas_open(&other, frame);
        paint(etch_triangle_gouraud, &other, v, etch_kernel_gouraud);
        paint(etch_triangle_gouraud_depth, &canvas, v, etch_kernel_gouraud_lequal);
        for (y = w.y0; y < w.y1; y++)
            for (x = w.x0; x < w.x1; x++)
                wrong += test_canvas_at(&canvas, x, y) != test_canvas_at(&other, x, y);
        CHECK_EQ(wrong, 0);
    }
}

/* ---- byte order -------------------------------------------------------------------------------
 */

/* `canvas` plain and `other` swapped hold the same picture and the same depths. */
static void compare_swapped(void)
{
    int32_t x, y, wrong = 0;

    for (y = 0; y < frame.y1; y++) {
        for (x = 0; x < frame.x1; x++) {
            const size_t at = etch_surface_index(&canvas.surface, (int16_t)x, (int16_t)y);
            const uint16_t plain = canvas.surface.pixels[at];
            const uint16_t swapped = other.surface.pixels[at];

            wrong += other.surface.depth[at] != canvas.surface.depth[at];
            wrong += swapped != etch_rgb565_swap(plain) &&
                     !(plain == TEST_BACKGROUND && swapped == TEST_BACKGROUND);
        }
    }
    CHECK_EQ(wrong, 0);
}

static void swapped_kernels_swap_bytes(void)
{
    static const struct {
        painter *plain_painter, *swapped_painter;
        etch_kernel *plain, *swapped;
    } pairs[] = {
        {etch_triangle_flat, etch_triangle_flat_swapped, etch_kernel_flat, etch_kernel_flat},
        {etch_triangle_flat_depth, etch_triangle_flat_depth_swapped, etch_kernel_flat_less,
         etch_kernel_flat_less},
        {etch_triangle_flat_depth, etch_triangle_flat_depth_swapped, etch_kernel_flat_lequal,
         etch_kernel_flat_lequal},
        {etch_triangle_gouraud, etch_triangle_gouraud, etch_kernel_gouraud,
         etch_kernel_gouraud_swapped},
        {etch_triangle_gouraud_depth, etch_triangle_gouraud_depth, etch_kernel_gouraud_less,
         etch_kernel_gouraud_less_swapped},
        {etch_triangle_gouraud_depth, etch_triangle_gouraud_depth, etch_kernel_gouraud_lequal,
         etch_kernel_gouraud_lequal_swapped}};
    uint32_t seed = 54;
    int32_t i;

    for (i = 0; i < TEST_COUNT(6000) && !test_failed(); i++) {
        struct etch_vertex v[2][3];
        int k;

        test_canvas_open(&canvas, frame);
        test_canvas_open(&other, frame);
        for (k = 0; k < 2; k++) {
            random_vertices(v[k], (enum test_triangle_kind)(i % TEST_TRIANGLE_KINDS), &seed);
            paint(pairs[i % 6].plain_painter, &canvas, v[k], pairs[i % 6].plain);
            paint(pairs[i % 6].swapped_painter, &other, v[k], pairs[i % 6].swapped);
        }
        compare_swapped();
    }
}

/* Flat triangles are in the rounded colour of vertex 0, on the triangle's pixels. */
static void flat_takes_vertex_0(void)
{
    uint32_t seed = 55;
    int32_t i, x, y;

    for (i = 0; i < TEST_COUNT(2000) && !test_failed(); i++) {
        struct etch_vertex v[3];
        struct oracle_triangle t;
        uint16_t color;
        int32_t wrong = 0;

        random_vertices(v, (enum test_triangle_kind)(i % TEST_TRIANGLE_KINDS), &seed);
        color = etch_rgb565(v[0].r, v[0].g, v[0].b);
        t = outline_of(v);
        test_canvas_open(&canvas, frame);
        paint(etch_triangle_flat, &canvas, v, etch_kernel_flat);
        for (y = 0; y < frame.y1; y++)
            for (x = 0; x < frame.x1; x++)
                wrong += test_canvas_at(&canvas, x, y) !=
                         (oracle_triangle_covers(&t, x, y) ? color : TEST_BACKGROUND);
        CHECK_EQ(wrong, 0);
    }
}

void suite_kernel(void)
{
    RUN(every_depth_test_by_the_macro);
    RUN(shipped_less_and_lequal);
    RUN(same_triangle_twice);
    RUN(swapped_kernels_swap_bytes);
    RUN(flat_takes_vertex_0);
}
