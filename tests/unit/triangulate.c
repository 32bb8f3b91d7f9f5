/* tests/unit: simple polygons to triangles: the pixels of the polygon, each once. */
#include "core/raster/polygon.h"
#include "core/raster/triangulate.h"
#include "core/base/trig.h"
#include "tests/harness/bands.h"

void suite_triangulate(void);

enum {
    POINTS = 120
};

static struct test_canvas canvas, other;
static struct etch_polygon_edge edges[POINTS];
static struct etch_ring_node nodes[2 * POINTS];
static struct etch_point_q8 points[POINTS];
static int32_t triangles, made;
static int winding; /* of the triangles that come: all the same */
static struct test_run_log runs;

static void take(void *context, const uint16_t v[3])
{
    const struct test_run_paint *paint = context;
    const struct etch_point_q8 corner[3] = {points[v[0]], points[v[1]], points[v[2]]};
    struct etch_triangle t;

    triangles++;
    made++;
    if (!CHECK(etch_triangle_setup(&t, corner)))
        return;
    CHECK(winding == 0 || t.winding == winding);
    winding = t.winding;
    runs.next_row = INT32_MIN;
    etch_triangle_runs(&canvas.surface, &t, &paint->paint);
}

/* Draws both ways and compares. */
static void compare(const uint16_t *size, uint16_t contours)
{
    const struct test_run_paint paint = test_band_paint(&runs, TEST_INK);
    struct etch_polygon polygon;
    uint16_t i, n = 0;

    test_canvas_wipe(&canvas);
    test_canvas_wipe(&other);
    winding = 0;
    made = 0;
    CHECK_EQ(contours == 1
                 ? etch_triangulate(points, size[0], nodes, take, (void *)(uintptr_t)&paint)
                 : etch_triangulate_holes(points, size, contours, nodes, 2 * POINTS, take,
                                          (void *)(uintptr_t)&paint),
             ETCH_OK);
    CHECK(!runs.broken); /* no pixel twice */
    runs.next_row = INT32_MIN;
    etch_polygon_init(&polygon, edges, POINTS);
    for (i = 0; i < contours; n = (uint16_t)(n + size[i++]))
        CHECK_EQ(etch_polygon_add(&polygon, points + n, size[i]), ETCH_OK);
    CHECK(made <= n + 2 * contours - 4);
    etch_polygon_runs_evenodd(&other.surface, &polygon, &paint.paint);
    if (!CHECK_EQ(test_canvas_hash(&canvas), test_canvas_hash(&other))) {
        for (i = 0; i < n; i++)
            test_note("x", points[i].x), test_note("y", points[i].y);
    }
}

/* n corners round (cx, cy), each nearer than `most` and further than `least`: star-shaped, so
 * simple; some repeat, some are in line with their neighbours. */
static void star(uint16_t at, uint16_t n, int32_t cx, int32_t cy, int32_t least, int32_t most,
                 bool reversed, uint32_t *seed)
{
    uint16_t i;

    for (i = 0; i < n; i++) {
        const uint16_t angle = (uint16_t)((uint32_t)(reversed ? n - 1 - i : i) * 65536 / n);
        const int32_t r = test_range(seed, least, most);
        struct etch_point_q8 *p = &points[at + i];

        p->x = cx + (int32_t)((int64_t)etch_cos_q30(angle) * r >> 30);
        p->y = cy + (int32_t)((int64_t)etch_sin_q30(angle) * r >> 30);
        if (n >= 8 && i % 2 != 0 &&
            test_range(seed, 0, 9) == 0) /* 90 degrees to the next at most */
            *p = points[at + i - 1];
    }
}

static void open(void)
{
    const struct etch_rect w = {0, 0, 64, 48};

    test_canvas_open(&canvas, w);
    test_canvas_open(&other, w);
}

static void stars_are_their_triangles(void)
{
    uint32_t seed = 1;
    int32_t i;

    open();
    for (i = 0; i < TEST_COUNT(1500) && !test_failed(); i++) {
        const uint16_t n = (uint16_t)test_range(&seed, 3, 40);
        const int32_t r = i % 10 == 0 ? 8000000 : 7000;

        star(0, n, 32 * 256, 24 * 256, test_range(&seed, 0, 1) != 0 ? 0 : r / 2, r, i % 2 != 0,
             &seed);
        compare(&n, 1);
    }
}

/* Histograms: many straight corners, on centres and between. */
static void histograms_are_their_triangles(void)
{
    uint32_t seed = 2;
    int32_t i;

    open();
    for (i = 0; i < TEST_COUNT(1000) && !test_failed(); i++) {
        const uint16_t columns = (uint16_t)test_range(&seed, 1, 20);
        const int32_t step = test_range(&seed, 1, 3) * 128;
        uint16_t n = 0, k;

        points[n].x = 100, points[n++].y = 47 * 256;
        for (k = 0; k < columns; k++) {
            const int32_t top = test_range(&seed, 1, 6) * 1024 + 128;

            points[n].x = 100 + k * 2 * step, points[n++].y = top;
            points[n].x = 100 + (k + 1) * 2 * step, points[n++].y = top;
        }
        points[n].x = 100 + columns * 2 * step, points[n++].y = 47 * 256;
        for (k = 0; k < columns; k++) /* the floor in pieces, straight */
            points[n].x = 100 + (columns - k) * 2 * step - 50, points[n++].y = 47 * 256;
        compare(&n, 1);
    }
}

/* A spiral of two arms' width: corners that see little. */
static void spirals_are_their_triangles(void)
{
    uint16_t n = 100, i;

    open();
    for (i = 0; i < n; i++) {
        const uint16_t k = i < 50 ? i : (uint16_t)(99 - i);
        const uint16_t angle = (uint16_t)(k * 5000);
        const int32_t r = 300 + k * 110 + (i < 50 ? 0 : 350);

        points[i].x = 32 * 256 + (int32_t)((int64_t)etch_cos_q30(angle) * r >> 30);
        points[i].y = 24 * 256 + (int32_t)((int64_t)etch_sin_q30(angle) * r >> 30);
    }
    compare(&n, 1);
    CHECK(made >= 90);
}

/* Up to eight holes in their own cells of a grid, of either winding, on and off the same lines. */
static void holes_are_left_out(void)
{
    uint32_t seed = 3;
    int32_t i;

    open();
    for (i = 0; i < TEST_COUNT(1000) && !test_failed(); i++) {
        uint16_t size[10] = {8}, contours = 1, n = 8, k;

        star(0, 8, 32 * 256, 24 * 256, 46 * 256, 64 * 256, i % 2 != 0, &seed);
        for (k = 0; k < 8; k++) {
            const uint16_t corners = (uint16_t)test_range(&seed, 3, 9);
            const int32_t cx = (k % 4) * 12 * 256 + 14 * 256, cy = (k / 4) * 14 * 256 + 17 * 256;

            if (test_range(&seed, 0, 2) == 0)
                continue;
            size[contours++] = corners;
            star(n, corners, cx, cy, 300, 1500, test_range(&seed, 0, 1) != 0, &seed);
            n = (uint16_t)(n + corners);
        }
        if (i % 4 == 0 && contours > 1) { /* one of no area, which is passed over */
            points[n] = points[n + 1] = points[0];
            size[contours++] = 2;
        }
        compare(size, contours);
    }
}

/* Rectangles side by side: bridges along lines where corners of other holes lie. */
static void holes_in_line_are_left_out(void)
{
    static const uint16_t size[] = {4, 4, 4, 4, 4};
    int32_t k;

    open();
    for (k = 0; k < 5; k++) {
        const int32_t x0 = k == 0 ? 0 : k * 10 * 256, x1 = k == 0 ? 64 * 256 : x0 + 5 * 256;
        const int32_t y0 = k == 0 ? 0 : 10 * 256, y1 = k == 0 ? 48 * 256 : 20 * 256;

        points[4 * k].x = points[4 * k + 3].x = x0;
        points[4 * k + 1].x = points[4 * k + 2].x = x1;
        points[4 * k].y = points[4 * k + 1].y = y0;
        points[4 * k + 2].y = points[4 * k + 3].y = y1;
    }
    compare(size, 5);
}

/* Two holes whose sides lie on one line with the bridge between them: straight corners that an edge
 * past them would block. */
static void bridges_may_go_on_along_sides(void)
{
    static const uint16_t size[] = {6, 3, 3};
    static const struct etch_point_q8 v[] = {{1293, 4439}, {4096, 640}, {9900, 10},   {4096, 4736},
                                             {6144, 4736}, {0, 6784},   {7936, 1152}, {8192, 896},
                                             {7680, 896},  {8704, 640}, {8704, 384},  {8448, 640}};

    open();
    for (uint8_t i = 0; i < 12; i++)
        points[i] = v[i];
    compare(size, 3);
}

static void count(void *context, const uint16_t v[3])
{
    (void)v;
    ++*(int32_t *)context;
}

/* What is not simple ends, with or without triangles; nothing is written beyond the memory. */
static void anything_ends(void)
{
    uint32_t seed = 4;
    int32_t i, refused = 0;

    for (i = 0; i < TEST_COUNT(2000); i++) {
        const uint16_t size[3] = {(uint16_t)test_range(&seed, 0, 20),
                                  (uint16_t)test_range(&seed, 0, 9),
                                  (uint16_t)test_range(&seed, 0, 9)};
        const uint16_t n = (uint16_t)(size[0] + size[1] + size[2]);
        const int32_t limit = i % 2 != 0 ? 1 << 23 : 3;
        enum etch_status status;
        int32_t got = 0;
        uint16_t k;

        for (k = 0; k < n; k++) {
            points[k].x = test_range(&seed, -limit, limit);
            points[k].y = test_range(&seed, -limit, limit);
        }
        nodes[n + 6].vertex = 12345;
        status = etch_triangulate_holes(points, size, 3, nodes, (uint16_t)(n + 6), count, &got);
        CHECK(status == ETCH_OK || status == ETCH_EINVAL);
        CHECK(got <= n + 4);
        CHECK_EQ(nodes[n + 6].vertex, 12345);
        refused += status == ETCH_EINVAL;
        got = 0;
        nodes[n].vertex = 12345;
        status = etch_triangulate(points, n, nodes, count, &got);
        CHECK(status == ETCH_OK || status == ETCH_EINVAL);
        CHECK(got <= n);
        CHECK_EQ(nodes[n].vertex, 12345);
    }
    CHECK(refused > 0);
}

static void small_and_wrong_input(void)
{
    static const uint16_t none[] = {2, 4}, some[] = {4, 3};
    int32_t got = 0;

    CHECK_EQ(etch_triangulate(points, 0, NULL, count, &got), ETCH_OK);
    CHECK_EQ(etch_triangulate(points, 2, NULL, count, &got), ETCH_OK);
    CHECK_EQ(etch_triangulate_holes(points, none, 0, NULL, 0, count, &got), ETCH_OK);
    CHECK_EQ(etch_triangulate_holes(points, none, 2, nodes, 10, count, &got), ETCH_OK);
    CHECK_EQ(etch_triangulate_holes(points, some, 2, nodes, 10, count, &got), ETCH_ENOMEM);
    CHECK_EQ(got, 0);
}

void suite_triangulate(void)
{
    RUN(stars_are_their_triangles);
    RUN(histograms_are_their_triangles);
    RUN(spirals_are_their_triangles);
    RUN(holes_are_left_out);
    RUN(holes_in_line_are_left_out);
    RUN(bridges_may_go_on_along_sides);
    RUN(anything_ends);
    RUN(small_and_wrong_input);
    test_print_count("", triangles, " triangles, no pixel of their polygons twice or left out");
}
