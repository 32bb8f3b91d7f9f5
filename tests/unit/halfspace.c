/* tests/unit: the half-space traversal against the edge walk and the definition of coverage. */
#include "core/raster/halfspace.h"
#include "tests/harness/canvas.h"
#include "tests/harness/shapes.h"
#include "tests/oracle/triangle.h"

void suite_halfspace(void);

static struct test_canvas canvas;

static void try_triangle(const struct test_triangle *shape)
{
    const struct etch_rect clip = canvas.surface.clip;
    const struct etch_point_q8 v[3] = {
        {shape->x[0], shape->y[0]}, {shape->x[1], shape->y[1]}, {shape->x[2], shape->y[2]}};
    struct test_run_log log;
    struct test_run_paint paint = test_run_paint(&log, TEST_INK);
    struct oracle_triangle exact;
    struct etch_triangle t;
    uint32_t hash;
    int32_t x, y, wrong = 0;

    oracle_triangle_make(&exact, shape->x, shape->y);
    if (!etch_triangle_setup(&t, v))
        return;
    etch_triangle_runs_halfspace(&canvas.surface, &t, &paint.paint);
    for (y = clip.y0; y < clip.y1; y++)
        for (x = clip.x0; x < clip.x1; x++)
            wrong += oracle_triangle_covers(&exact, x, y) != test_canvas_drawn(&canvas, x, y);
    CHECK_EQ(wrong, 0);
    CHECK(!log.broken);
    CHECK_INSIDE(&canvas);
    hash = test_canvas_hash(&canvas);
    test_canvas_wipe(&canvas);
    paint = test_run_paint(&log, TEST_INK);
    etch_triangle_runs(&canvas.surface, &t, &paint.paint);
    CHECK_EQ(test_canvas_hash(&canvas), hash);
    if (test_failed())
        for (x = 0; x < 3; x++) {
            test_note("x", shape->x[x]);
            test_note("y", shape->y[x]);
        }
}

static void pixels_are_those_of_the_edge_walk(void)
{
    static const struct etch_rect windows[] = {
        {0, 0, 48, 36}, {150, 100, 190, 141}, {32727, 32731, 32767, 32767}};
    uint32_t seed = 1;
    int32_t i;

    for (i = 0; i < TEST_COUNT(26000) && !test_failed(); i++) {
        const struct etch_rect w = windows[i % 3];
        struct etch_rect clip = w;
        struct test_triangle shape;

        test_triangle_make(&shape, (enum test_triangle_kind)(i % TEST_TRIANGLE_KINDS), w, &seed);
        test_canvas_open(&canvas, w);
        if (i % 2 != 0)
            clip.x0 = (int16_t)(w.x0 + 5), clip.y1 = (int16_t)(w.y1 - 3);
        test_canvas_clip(&canvas, clip);
        try_triangle(&shape);
    }
    test_print_count("", i, " triangles of every kind, no differing pixel");
}

void suite_halfspace(void)
{
    RUN(pixels_are_those_of_the_edge_walk);
}
