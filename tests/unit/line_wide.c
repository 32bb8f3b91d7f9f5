/* tests/unit: lines of a width: the rectangle's corners against exact arithmetic, its pixels
 * against the definition of coverage. */
#include "core/draw/line.h"
#include "core/fragment/gouraud.h"
#include "core/raster/triangle.h"
#include "tests/harness/canvas.h"
#include "tests/oracle/triangle.h"
#include "tests/oracle/wide.h"

void suite_line_wide(void);

static struct test_canvas canvas;

/* What the painter got: the corners, round the rectangle. */
static struct etch_vertex corner[4];
static int calls;

static void take(const struct etch_surface *s, const struct etch_vertex *const v[3],
                 etch_kernel *kernel)
{
    (void)s, (void)kernel;
    if (calls++ == 0)
        corner[0] = *v[0], corner[1] = *v[1], corner[2] = *v[2];
    else
        corner[3] = *v[2];
}

static uint64_t size(int64_t v)
{
    return v < 0 ? (uint64_t)-v : (uint64_t)v;
}

/* |n - width d / length| <= 1/2 + 2^-13, where length^2 = dx^2 + dy^2:
 * (2^14 n - 2^13 - 2) length <= 2^14 width d <= (2^14 n + 2^13 + 2) length, squared. */
static bool is_rounded(int64_t n, int64_t d, int64_t width, uint64_t square)
{
    const uint64_t magnitude = size(n),
                   low = magnitude * 16384 > 8194 ? magnitude * 16384 - 8194 : 0;
    const uint64_t high = magnitude * 16384 + 8194;
    const uint64_t value = size(d) * (uint64_t)width; /* below 2^40 */
    const struct wide exact = wide_scale(wide_product(value, value), UINT32_C(1) << 28);
    /* low, high < 2^31 and square < 2^50 */
    const struct wide least = wide_product(low * low, square);
    const struct wide most = wide_product(high * high, square);

    return wide_at_most(least, exact) && wide_at_most(exact, most) &&
           (n == 0 || d == 0 || (n < 0) == (d < 0));
}

static int32_t position(uint32_t *seed, int kind)
{
    const int32_t limit = (INT32_C(1) << 23) - 32768;

    return kind == 0   ? test_range(seed, -limit, limit)
           : kind == 1 ? test_range(seed, -9, 9)
                       : test_range(seed, -2560, 14 * 1024);
}

static void corners_are_exact(void)
{
    uint32_t seed = 1;
    int32_t i;

    for (i = 0; i < TEST_COUNT(100000) && !test_failed(); i++) {
        struct etch_vertex v[2] = {{0, 0, 1, 2, 3, 4, 5}, {0, 0, 6, 7, 8, 9, 10}};
        const struct etch_vertex *const line[2] = {&v[0], &v[1]};
        const uint16_t width = (uint16_t)(i % 2 == 0 ? test_range(&seed, 1, 65535)
                                                     : test_range(&seed, 1, 2000));
        int64_t dx, dy, nx, ny;
        int k;

        for (k = 0; k < 2; k++) {
            v[k].x_q8 = position(&seed, i % 3);
            v[k].y_q8 = position(&seed, i % 3);
        }
        if (i % 7 == 0)
            v[1].x_q8 = v[0].x_q8;
        if (i % 7 == 1)
            v[1].y_q8 = v[0].y_q8;
        dx = v[1].x_q8 - v[0].x_q8, dy = v[1].y_q8 - v[0].y_q8;
        calls = 0;
        etch_line_wide(NULL, line, width, take, NULL);
        if (dx == 0 && dy == 0) {
            CHECK_EQ(calls, 0);
            continue;
        }
        CHECK_EQ(calls, 2);
        nx = corner[3].x_q8 - corner[0].x_q8, ny = corner[3].y_q8 - corner[0].y_q8;
        CHECK_EQ(corner[2].x_q8 - corner[1].x_q8, nx);
        CHECK_EQ(corner[2].y_q8 - corner[1].y_q8, ny);
        CHECK(nx + ny >= 0);
        /* the odd unit where x and y are larger */
        CHECK_EQ(corner[0].x_q8 + corner[3].x_q8 - v[0].x_q8 * 2, nx & 1);
        CHECK_EQ(corner[0].y_q8 + corner[3].y_q8 - v[0].y_q8 * 2, ny & 1);
        CHECK_EQ(corner[1].x_q8 - corner[0].x_q8, dx);
        CHECK_EQ(corner[1].y_q8 - corner[0].y_q8, dy);
        CHECK(corner[0].r == 2 && corner[3].z_q16 == 1 && corner[1].a == 10 && corner[2].g == 8);
        if (dx == 0)
            CHECK(nx == width && ny == 0);
        if (dy == 0)
            CHECK(ny == width && nx == 0);
        if (!CHECK((is_rounded(nx, -dy, width, (uint64_t)(dx * dx + dy * dy)) &&
                    is_rounded(ny, dx, width, (uint64_t)(dx * dx + dy * dy))) ||
                   (is_rounded(nx, dy, width, (uint64_t)(dx * dx + dy * dy)) &&
                    is_rounded(ny, -dx, width, (uint64_t)(dx * dx + dy * dy))))) {
            test_note("dx", dx);
            test_note("dy", dy);
            test_note("nx", nx);
            test_note("ny", ny);
            test_note("width", width);
        }
    }
    test_print_count("", i, " lines of a width, each corner within 1/2 + 2^-13 of 1/256 px");
}

/* Counts into the canvas, as a painter. */
static void count(const struct etch_surface *s, const struct etch_vertex *const v[3],
                  etch_kernel *kernel)
{
    const struct etch_point_q8 p[3] = {
        {v[0]->x_q8, v[0]->y_q8}, {v[1]->x_q8, v[1]->y_q8}, {v[2]->x_q8, v[2]->y_q8}};
    struct test_run_log log;
    struct test_run_paint paint = test_run_paint(&log, 1);
    struct etch_triangle t;

    take(s, v, kernel);
    paint.count = true;
    if (etch_triangle_setup(&t, p))
        etch_triangle_runs(s, &t, &paint.paint);
}

/* The pixels are those whose centres are in the rectangle, split the other way; none is drawn
 * twice; both directions give the same. */
static void pixels_are_the_rectangle(void)
{
    const struct etch_rect window = {0, 0, 48, 36};
    uint32_t seed = 2;
    int32_t i, x, y;

    test_canvas_open(&canvas, window);
    for (i = 0; i < TEST_COUNT(5000) && !test_failed(); i++) {
        struct etch_vertex v[2] = {{0, 0, 0, 0, 0, 0, 0}, {0, 0, 0, 0, 0, 0, 0}};
        const struct etch_vertex *const line[2] = {&v[0], &v[1]}, *const back[2] = {&v[1], &v[0]};
        const uint16_t width = (uint16_t)test_range(&seed, 1, i % 9 == 0 ? 65535 : 3000);
        struct oracle_triangle half[2];
        uint32_t hash;
        int k;

        for (k = 0; k < 2; k++) {
            v[k].x_q8 = position(&seed, i % 5 == 0 ? 0 : 2);
            v[k].y_q8 = position(&seed, i % 5 == 0 ? 0 : 2);
        }
        if (v[0].x_q8 == v[1].x_q8 && v[0].y_q8 == v[1].y_q8)
            continue;
        test_canvas_wipe(&canvas);
        calls = 0;
        etch_line_wide(&canvas.surface, line, width, count, NULL);
        for (k = 0; k < 2; k++) {
            const struct etch_vertex *c[3] = {&corner[k], &corner[k + 1], &corner[3]};

            if (k == 1)
                c[0] = &corner[1], c[1] = &corner[2];
            else
                c[0] = &corner[0], c[1] = &corner[1];
            const int32_t px[3] = {c[0]->x_q8, c[1]->x_q8, c[2]->x_q8};
            const int32_t py[3] = {c[0]->y_q8, c[1]->y_q8, c[2]->y_q8};

            oracle_triangle_make(&half[k], px, py);
        }
        for (y = 0; y < 36; y++)
            for (x = 0; x < 48; x++)
                CHECK_EQ(test_canvas_at(&canvas, x, y) - TEST_BACKGROUND,
                         oracle_triangle_covers(&half[0], x, y) ||
                             oracle_triangle_covers(&half[1], x, y));
        hash = test_canvas_hash(&canvas);
        test_canvas_wipe(&canvas);
        etch_line_wide(&canvas.surface, back, width, count, NULL);
        CHECK_EQ(test_canvas_hash(&canvas), hash);
        if (test_failed()) {
            test_note("x0", v[0].x_q8);
            test_note("y0", v[0].y_q8);
            test_note("x1", v[1].x_q8);
            test_note("y1", v[1].y_q8);
            test_note("width", width);
        }
    }
}

/* At the ends of the range nothing leaves it. */
static void corners_are_held(void)
{
    const int32_t most = INT32_C(1) << 23;
    const struct etch_vertex v[2] = {{-most, -most, 0, 0, 0, 0, 0},
                                     {most, most - 3, 0, 0, 0, 0, 0}};
    const struct etch_vertex *const line[2] = {&v[0], &v[1]};
    int k;

    calls = 0;
    etch_line_wide(NULL, line, 65535, take, NULL);
    for (k = 0; k < 4; k++)
        CHECK(corner[k].x_q8 >= -most && corner[k].x_q8 <= most && corner[k].y_q8 >= -most &&
              corner[k].y_q8 <= most);
}

static void a_picture(void)
{
    const struct etch_rect window = {0, 0, 10, 4};
    const struct etch_vertex v[2] = {{256, 512, 0, 255, 255, 255, 0},
                                     {9 * 256, 512, 0, 255, 255, 255, 0}};
    const struct etch_vertex *const line[2] = {&v[0], &v[1]};

    test_canvas_open(&canvas, window);
    etch_line_wide(&canvas.surface, line, 512, etch_triangle_gouraud, etch_kernel_gouraud);
    CHECK_PICTURE(&canvas, ".........."
                           ".########."
                           ".########."
                           "..........");
}

void suite_line_wide(void)
{
    RUN(a_picture);
    RUN(corners_are_exact);
    RUN(pixels_are_the_rectangle);
    RUN(corners_are_held);
}
