/* tests/unit: the small triangles against their fast siblings and the oracle: the same pixels and
 * the same exact planes, for every kind of triangle, window and clip. */
#include "core/draw/shapes.h"
#include "core/draw/triangle_small.h"
#include "core/fragment/flat_small.h"
#include "core/raster/plane.h"
#include "core/raster/plane_small.h"
#include "core/raster/triangle_small.h"
#include "tests/harness/canvas.h"
#include "tests/harness/shapes.h"
#include "tests/oracle/triangle.h"

void suite_triangle_small(void);

static struct test_canvas canvas;

/* Windows: at the origin, in the middle of the frame and in its far corner. */
static const struct etch_rect windows[] = {
    {0, 0, 48, 36}, {0, 0, 33, 25}, {150, 100, 190, 141}, {32727, 32731, 32767, 32767}};

/* Opens window i with a clip that cuts it every other time. */
static void open_window(uint32_t *seed, int32_t i)
{
    const struct etch_rect w = windows[i % 4];
    struct etch_rect clip = w;

    test_canvas_open(&canvas, w);
    if (i % 8 >= 4) {
        clip.x0 = (int16_t)test_range(seed, w.x0, w.x1);
        clip.y0 = (int16_t)test_range(seed, w.y0, w.y1);
        clip.x1 = (int16_t)test_range(seed, clip.x0, w.x1);
        clip.y1 = (int16_t)test_range(seed, clip.y0, w.y1);
        test_canvas_clip(&canvas, clip);
    }
}

/* Triangle i of a kind, with its window opened. */
static void make(struct test_triangle *t, struct etch_point_q8 v[3], int32_t i, uint32_t *seed)
{
    int k;

    open_window(seed, i);
    test_triangle_make(t, (enum test_triangle_kind)(i / 8 % TEST_TRIANGLE_KINDS), windows[i % 4],
                       seed);
    for (k = 0; k < 3; k++) {
        v[k].x = t->x[k];
        v[k].y = t->y[k];
    }
}

static void note_triangle(const struct test_triangle *t)
{
    int i;

    for (i = 0; i < 3; i++) {
        test_note("x_q8", t->x[i]);
        test_note("y_q8", t->y[i]);
    }
}

static void compare_with_oracle(const struct test_triangle *t)
{
    const struct etch_rect clip = canvas.surface.clip;
    struct oracle_triangle o;
    int32_t x, y, wrong = 0;

    oracle_triangle_make(&o, t->x, t->y);
    for (y = clip.y0; y < clip.y1; y++)
        for (x = clip.x0; x < clip.x1; x++)
            wrong += oracle_triangle_covers(&o, x, y) != test_canvas_drawn(&canvas, x, y);
    if (!CHECK_EQ(wrong, 0))
        note_triangle(t);
    CHECK_ONCE(&canvas);
}

static void runs_are_those_of_the_fast_walker(void)
{
    uint32_t seed = 91;
    int32_t i;

    for (i = 0; i < TEST_COUNT(120000) && !test_failed(); i++) {
        struct etch_point_q8 v[3], turned[3];
        struct etch_triangle setup;
        struct test_triangle t;
        struct test_run_log small, fast, other;
        const struct test_run_paint small_paint = test_run_paint(&small, TEST_INK);
        const struct test_run_paint fast_paint = test_run_paint(&fast, TEST_INK);
        const struct test_run_paint other_paint = test_run_paint(&other, TEST_INK);
        int k;

        make(&t, v, i, &seed);
        if (etch_triangle_setup(&setup, v))
            etch_triangle_runs(&canvas.surface, &setup, &fast_paint.paint);
        test_canvas_wipe(&canvas);
        for (k = 0; k < 3; k++)
            turned[k] = v[test_orders[1 + i % 5][k]];
        etch_triangle_runs_small(&canvas.surface, turned, &other_paint.paint);
        test_canvas_wipe(&canvas);
        etch_triangle_runs_small(&canvas.surface, v, &small_paint.paint);
        CHECK(!small.broken);
        CHECK_EQ(small.pixels, fast.pixels);
        CHECK_EQ(small.hash, fast.hash);
        if (!CHECK_EQ(small.hash, other.hash))
            note_triangle(&t);
        compare_with_oracle(&t);
    }
}

static void planes_are_the_exact_ones(void)
{
    uint32_t seed = 92;
    int32_t i;

    for (i = 0; i < TEST_COUNT(120000) && !test_failed(); i++) {
        struct etch_plane exact = {0, 0, 0}, small = {0, 0, 0};
        struct etch_point_q8 v[3];
        struct etch_triangle setup;
        struct test_triangle t;
        uint32_t value[3];
        bool is_drawn;
        int k;

        make(&t, v, i, &seed);
        for (k = 0; k < 3; k++) /* nothing, everything, equal ones and all between */
            value[k] = i % 3 == 0   ? test_random(&seed)
                       : i % 3 == 1 ? (test_range(&seed, 0, 1) ? UINT32_MAX : 0)
                                    : test_random(&seed) >> 8;
        is_drawn = etch_triangle_setup(&setup, v);
        if (is_drawn)
            etch_plane_setup(&exact, &setup, value);
        CHECK_EQ(etch_plane_setup_small(&small, v, value), is_drawn);
        CHECK_EQ(small.origin, exact.origin);
        CHECK_EQ(small.dx, exact.dx);
        if (!CHECK_EQ(small.dy, exact.dy))
            note_triangle(&t);
    }
}

/* etch_triangle_fill_small and etch_triangle_flat_small draw what the fast calls draw. */
static void flat_triangles_are_the_fast_ones(void)
{
    uint32_t seed = 93;
    int32_t i;

    for (i = 0; i < TEST_COUNT(40000) && !test_failed(); i++) {
        struct etch_vertex vertex[3] = {{0, 0, 0, 0, 0, 0, 0}};
        const struct etch_vertex *const v[3] = {&vertex[0], &vertex[1], &vertex[2]};
        struct etch_point_q8 points[3];
        struct test_triangle t;
        uint32_t hash;
        int16_t p[6];
        int k;

        make(&t, points, i, &seed);
        for (k = 0; k < 3; k++) {
            p[2 * k] = (int16_t)(t.x[k] >> 8);
            p[2 * k + 1] = (int16_t)(t.y[k] >> 8);
            vertex[k].x_q8 = t.x[k];
            vertex[k].y_q8 = t.y[k];
            vertex[k].r = (uint8_t)test_range(&seed, 0, 255);
            vertex[k].g = (uint8_t)test_range(&seed, 0, 255);
        }
        etch_triangle_fill(&canvas.surface, p[0], p[1], p[2], p[3], p[4], p[5], TEST_INK);
        hash = test_canvas_hash(&canvas);
        test_canvas_wipe(&canvas);
        etch_triangle_fill_small(&canvas.surface, p[0], p[1], p[2], p[3], p[4], p[5], TEST_INK);
        CHECK_EQ(test_canvas_hash(&canvas), hash);
        CHECK_ONCE(&canvas);
        test_canvas_wipe(&canvas);
        etch_triangle_flat(&canvas.surface, v, etch_kernel_flat);
        hash = test_canvas_hash(&canvas);
        test_canvas_wipe(&canvas);
        etch_triangle_flat_small(&canvas.surface, v, etch_kernel_flat_small);
        if (!CHECK_EQ(test_canvas_hash(&canvas), hash))
            note_triangle(&t);
        CHECK_ONCE(&canvas);
    }
}

void suite_triangle_small(void)
{
    RUN(runs_are_those_of_the_fast_walker);
    RUN(planes_are_the_exact_ones);
    RUN(flat_triangles_are_the_fast_ones);
    test_print_count("", TEST_COUNT(120000), " triangles in two vertex orders, no differing pixel");
    test_print_count("", TEST_COUNT(120000), " planes, equal to the exact ones bit for bit");
}
