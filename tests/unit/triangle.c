/* tests/unit: triangle coverage against edge functions over every pixel, for every kind of
 * triangle that 16.16 vertices can make, through all the calls that fill one. */
#include "core/draw/shapes.h"
#include "core/draw/triangle.h"
#include "core/raster/triangle.h"
#include "tests/harness/canvas.h"
#include "tests/harness/shapes.h"
#include "tests/oracle/triangle.h"

void suite_triangle(void);

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
        clip.x0 = (int16_t)test_range(seed, w.x0 - 3, w.x1);
        clip.y0 = (int16_t)test_range(seed, w.y0 - 3, w.y1);
        clip.x1 = (int16_t)test_range(seed, clip.x0, w.x1);
        clip.y1 = (int16_t)test_range(seed, clip.y0, w.y1);
        test_canvas_clip(&canvas, clip);
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

/* Pixel by pixel, the canvas holds what the oracle says, and nothing outside the clip. */
static void compare(const struct test_triangle *t)
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

/* By set-up and runs, in one vertex order; returns the hash of the runs. */
static uint32_t draw_runs(const struct test_triangle *t, const uint8_t order[3])
{
    struct etch_point_q8 v[3];
    struct etch_triangle setup;
    struct test_run_log log;
    const struct test_run_paint paint = test_run_paint(&log, TEST_INK);
    int i;

    for (i = 0; i < 3; i++) {
        v[i].x = t->x[order[i]];
        v[i].y = t->y[order[i]];
    }
    if (etch_triangle_setup(&setup, v))
        etch_triangle_runs(&canvas.surface, &setup, &paint.paint);
    CHECK(!log.broken);
    return log.hash;
}

/* The other five orders of the vertices give the same runs. */
static void compare_orders(const struct test_triangle *t, uint32_t hash)
{
    int i;

    for (i = 1; i < 6; i++) {
        test_canvas_wipe(&canvas);
        if (!CHECK_EQ(draw_runs(t, test_orders[i]), hash))
            note_triangle(t);
    }
}

/* The kinds of test_triangle_make, `count` triangles each. */
static void fill_kind(enum test_triangle_kind kind, int32_t count)
{
    uint32_t seed = 77 + (uint32_t)kind;
    int32_t i;

    for (i = 0; i < count && !test_failed(); i++) {
        struct test_triangle t;

        open_window(&seed, i);
        test_triangle_make(&t, kind, windows[i % 4], &seed);
        {
            const uint32_t hash = draw_runs(&t, test_orders[0]);

            compare(&t);
            compare_orders(&t, hash);
        }
    }
}

/* One case a kind: 20,000 triangles each of thirteen kinds, in all six vertex orders. */
#define KIND(name)                                                                                 \
    static void triangles_##name(void)                                                             \
    {                                                                                              \
        fill_kind(TEST_TRIANGLE_##name, TEST_COUNT(20000));                                        \
    }
KIND(random)
KIND(thin)
KIND(tiny)
KIND(huge)
KIND(extreme)
KIND(centres)
KIND(corners)
KIND(sixteenths)
KIND(degenerate)
KIND(far)
KIND(screen)
KIND(sliver)
KIND(tall)

/* An edge 2^22 / 256 px tall that begins 1/256 px above a centre and passes it 1/2^30 px to the
 * right: the pixel is outside, by the last bit of the edge's start. */
static void tall_edge_just_beside_a_centre(void)
{
    static const struct test_triangle t = {{128, 129, 2048}, {127, 127 + (INT32_C(1) << 22), 127}};
    const struct etch_rect window = {0, 0, 8, 8};
    int i;

    for (i = 0; i < 6; i++) {
        test_canvas_open(&canvas, window);
        draw_runs(&t, test_orders[i]);
        CHECK(!test_canvas_drawn(&canvas, 0, 0));
        CHECK(test_canvas_drawn(&canvas, 1, 0));
        compare(&t);
    }
}

/* etch_triangle_fill: int16 vertices name pixels and stand at their centres. */
static void int16_vertices_stand_at_centres(void)
{
    uint32_t seed = 5;
    int32_t i;
    int k;

    for (i = 0; i < TEST_COUNT(20000) && !test_failed(); i++) {
        const bool wide = i % 3 == 0;
        struct test_triangle t;
        int16_t p[6];

        open_window(&seed, i);
        for (k = 0; k < 6; k++) {
            const struct etch_rect w = windows[i % 4];
            const int32_t near = k % 2 == 0 ? test_range(&seed, w.x0 - 20, w.x1 + 20)
                                            : test_range(&seed, w.y0 - 20, w.y1 + 20);
            const int32_t v = wide ? test_range(&seed, INT16_MIN, INT16_MAX) : near;

            p[k] = (int16_t)(v > INT16_MAX ? INT16_MAX : v);
            if (wide && test_range(&seed, 0, 9) == 0)
                p[k] = test_range(&seed, 0, 1) ? INT16_MAX : INT16_MIN;
            *(k % 2 == 0 ? &t.x[k / 2] : &t.y[k / 2]) = 256 * (int32_t)p[k] + 128;
        }
        etch_triangle_fill(&canvas.surface, p[0], p[1], p[2], p[3], p[4], p[5], TEST_INK);
        compare(&t);
    }
}

/* etch_triangle_fill_q16: any 16.16 vertices, snapped to 1/256 by round-half-up. */
static void q16_vertices_are_snapped(void)
{
    static const int32_t ends[] = {INT32_MIN, INT32_MIN + 127, INT32_MAX, INT32_MAX - 127, 0, 128};
    uint32_t seed = 6;
    int32_t i;
    int k;

    for (i = 0; i < TEST_COUNT(20000) && !test_failed(); i++) {
        struct etch_point_q16 v[3];
        struct test_triangle t;

        open_window(&seed, i);
        for (k = 0; k < 3; k++) {
            const struct etch_rect w = windows[i % 4];

            v[k].x = test_range(&seed, (w.x0 - 9) * 65536, w.x1 * 65536 - 1);
            v[k].y = test_range(&seed, (w.y0 - 9) * 65536, w.y1 * 65536 - 1);
            if (i % 3 == 0)
                v[k].x = (int32_t)test_random(&seed);
            if (i % 5 == 0)
                v[k].y = (int32_t)test_random(&seed);
            if (i % 7 == 0)
                v[k].x = ends[test_range(&seed, 0, 5)];
            if (i % 11 == 0)
                v[k].y = ends[test_range(&seed, 0, 5)];
            t.x[k] = (int32_t)(((int64_t)v[k].x + 128) >> 8);
            t.y[k] = (int32_t)(((int64_t)v[k].y + 128) >> 8);
        }
        etch_triangle_fill_q16(&canvas.surface, v, TEST_INK);
        compare(&t);
    }
}

/* What set-up says of a triangle: twice the area, winding, order. */
static void setup_tells_area_and_winding(void)
{
    uint32_t seed = 8;
    int32_t i;
    int k;

    for (i = 0; i < TEST_COUNT(20000) && !test_failed(); i++) {
        const enum test_triangle_kind kind = (enum test_triangle_kind)(i % TEST_TRIANGLE_KINDS);
        struct test_triangle t;
        struct etch_point_q8 v[3];
        struct etch_triangle setup;
        struct oracle_triangle o;
        bool drawn;

        test_triangle_make(&t, kind, windows[i % 4], &seed);
        oracle_triangle_make(&o, t.x, t.y);
        for (k = 0; k < 3; k++) {
            v[k].x = t.x[k];
            v[k].y = t.y[k];
        }
        drawn = etch_triangle_setup(&setup, v);
        CHECK_EQ(drawn, o.area != 0);
        if (!drawn)
            continue;
        CHECK_EQ(setup.area, o.area);
        CHECK_EQ(setup.winding, o.from[0] == 0 ? 1 : -1);
        for (k = 0; k < 3; k++) {
            CHECK_EQ(setup.p[k].x, t.x[setup.order[k]]);
            CHECK_EQ(setup.p[k].y, t.y[setup.order[k]]);
            CHECK(setup.x0 * 256 - 128 <= t.x[k] && t.x[k] <= setup.x1 * 256 + 128);
            CHECK(k == 0 || setup.p[k - 1].y < setup.p[k].y ||
                  (setup.p[k - 1].y == setup.p[k].y && setup.p[k - 1].x <= setup.p[k].x));
        }
    }
}

void suite_triangle(void)
{
    RUN(triangles_random);
    RUN(triangles_thin);
    RUN(triangles_tiny);
    RUN(triangles_huge);
    RUN(triangles_extreme);
    RUN(triangles_centres);
    RUN(triangles_corners);
    RUN(triangles_sixteenths);
    RUN(triangles_degenerate);
    RUN(triangles_far);
    RUN(triangles_screen);
    RUN(triangles_sliver);
    RUN(triangles_tall);
    RUN(tall_edge_just_beside_a_centre);
    RUN(int16_vertices_stand_at_centres);
    RUN(q16_vertices_are_snapped);
    RUN(setup_tells_area_and_winding);
    test_print_count("", TEST_COUNT(20000) * 13,
                     " triangles of thirteen kinds in six vertex orders, no differing pixel");
    test_print_count("", TEST_COUNT(20000) * 2, " by int16 and 16.16 vertices");
}
