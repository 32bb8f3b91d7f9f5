/* tests/unit: points of a size, each pixel by the definition. */
#include "core/base/rgb565.h"
#include "core/draw/point.h"
#include "core/fragment/gouraud.h"
#include "tests/harness/canvas.h"

void suite_point_runs(void);

static struct test_canvas canvas;

/* Twice the way from the point to the centre of pixel i, in 1/256 px. */
static int64_t twice(int32_t i, int32_t c_q8)
{
    return 2 * (256 * (int64_t)i + 128 - c_q8);
}

static bool square_covers(int32_t x_q8, int32_t y_q8, int32_t size, int32_t x, int32_t y)
{
    const int64_t dx = twice(x, x_q8), dy = twice(y, y_q8);

    return dx >= -size && dx < size && dy >= -size && dy < size;
}

static bool round_covers(int32_t x_q8, int32_t y_q8, int32_t size, int32_t x, int32_t y)
{
    const int64_t dx = twice(x, x_q8), dy = twice(y, y_q8);

    return dx * dx + dy * dy <= (int64_t)size * size;
}

static int32_t position(uint32_t *seed, int32_t lo, int32_t hi)
{
    const int32_t most = INT32_C(1) << 23;

    switch (test_range(seed, 0, 7)) {
    case 0: return test_range(seed, 0, 1) ? most : -most;
    case 1: return test_range(seed, -most, most);
    case 2: return 256 * test_range(seed, lo, hi) + 128;
    case 3: return 256 * test_range(seed, lo, hi);
    default: return test_range(seed, 256 * lo - 9000, 256 * hi + 9000);
    }
}

static uint16_t size_of(uint32_t *seed)
{
    switch (test_range(seed, 0, 5)) {
    case 0: return (uint16_t)(256 * test_range(seed, 0, 255));
    case 1: return (uint16_t)test_range(seed, 0, 3);
    case 2: return (uint16_t)test_range(seed, 65530, 65535);
    case 3: return (uint16_t)test_range(seed, 0, 65535);
    default: return (uint16_t)test_range(seed, 0, 6000);
    }
}

static void pixels_are_exact(void)
{
    static const struct etch_rect windows[] = {
        {0, 0, 48, 36}, {150, 100, 190, 141}, {32727, 32731, 32767, 32767}};
    uint32_t seed = 1;
    int32_t i, x, y;

    for (i = 0; i < TEST_COUNT(20000) && !test_failed(); i++) {
        const struct etch_rect w = windows[i % 3];
        const int32_t px = position(&seed, w.x0, w.x1), py = position(&seed, w.y0, w.y1);
        const uint16_t size = size_of(&seed);
        const bool is_round = i % 2 != 0;
        struct test_run_log log;
        const struct test_run_paint paint = test_run_paint(&log, TEST_INK);
        struct etch_rect clip = w;
        int32_t wrong = 0;

        test_canvas_open(&canvas, w);
        if (i % 4 > 1)
            clip.x0 = (int16_t)(w.x0 + 7), clip.y1 = (int16_t)(w.y1 - 9);
        test_canvas_clip(&canvas, clip);
        (is_round ? etch_point_runs_round : etch_point_runs_square)(&canvas.surface, px, py, size,
                                                                    &paint.paint);
        for (y = clip.y0; y < clip.y1; y++)
            for (x = clip.x0; x < clip.x1; x++)
                wrong += (is_round ? round_covers : square_covers)(px, py, size, x, y) !=
                         test_canvas_drawn(&canvas, x, y);
        if (!CHECK_EQ(wrong, 0) || !CHECK(!log.broken)) {
            test_note("x", px);
            test_note("y", py);
            test_note("size", size);
        }
        CHECK_INSIDE(&canvas);
    }
    test_print_count("", i, " points of every size, no differing pixel");
}

/* n px cover n x n pixels, wherever the centre is. */
static void whole_sizes_cover_squares(void)
{
    const struct etch_rect window = {0, 0, 48, 36};
    uint32_t seed = 2;
    int32_t i;

    test_canvas_open(&canvas, window);
    for (i = 0; i < TEST_COUNT(2000); i++) {
        const int32_t n = test_range(&seed, 0, 20);
        struct test_run_log log;
        const struct test_run_paint paint = test_run_paint(&log, TEST_INK);

        test_canvas_wipe(&canvas);
        etch_point_runs_square(&canvas.surface, test_range(&seed, 20 * 256, 25 * 256),
                               test_range(&seed, 15 * 256, 20 * 256), (uint16_t)(256 * n),
                               &paint.paint);
        CHECK_EQ(log.pixels, n * n);
    }
}

static void pictures(void)
{
    const struct etch_rect window = {0, 0, 12, 6};
    const struct etch_vertex v = {8 * 256 + 128, 2 * 256 + 128, UINT32_C(9) << 16, 255, 0, 0, 9};

    test_canvas_open(&canvas, window);
    etch_point_fill(&canvas.surface, 2 * 256, 2 * 256, 3 * 256, 1, etch_point_runs_square);
    etch_point_fill(&canvas.surface, 8 * 256 + 128, 2 * 256 + 128, 4 * 256, 2,
                    etch_point_runs_round);
    CHECK_PICTURE(&canvas, "aaa.....b..."
                           "aaa....bbb.."
                           "aaa...bbbbb."
                           ".......bbb.."
                           "........b..."
                           "............");
    etch_point_paint(&canvas.surface, &v, 256, etch_point_runs_round, etch_kernel_gouraud_less);
    CHECK_EQ(test_canvas_at(&canvas, 8, 2), etch_rgb565(255, 0, 0));
    CHECK_EQ(canvas.surface.depth[etch_surface_index(&canvas.surface, 8, 2)], 9);
    CHECK_EQ(test_canvas_at(&canvas, 8, 1), 2);
}

void suite_point_runs(void)
{
    RUN(pictures);
    RUN(pixels_are_exact);
    RUN(whole_sizes_cover_squares);
}
