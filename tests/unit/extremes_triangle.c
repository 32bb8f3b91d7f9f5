/* tests/unit: triangles at the extremes: corners at the ends of their formats, no area, the
 * thinnest slivers, vertices on pixel centres, the whole screen inside. Each against the definition
 * of coverage, and against the count that can be told beforehand. tests/EXTREMES.md lists what is
 * where. */
#include "core/draw/shapes.h"
#include "core/draw/triangle.h"
#include "tests/harness/canvas.h"
#include "tests/harness/shapes.h"
#include "tests/oracle/triangle.h"

void suite_extremes_triangle(void);

static struct test_canvas canvas;

static const struct etch_rect windows[] = {{0, 0, 16, 12}, {32751, 32755, 32767, 32767}};

/* What is snapped to v / 256; 32768.0 itself is no 16.16. */
static etch_q16 to_q16(int32_t v)
{
    return v == 8388608 ? INT32_MAX : v * 256;
}

/* Draws the triangle (1/256 px), in order `order`, and compares every pixel of the window with the
 * definition. Returns how many were drawn. */
static int32_t draw(const int32_t x[3], const int32_t y[3], int order)
{
    const struct etch_rect *w = &canvas.surface.window;
    const uint8_t *o = test_orders[order];
    struct etch_point_q16 v[3];
    struct oracle_triangle exact;
    int32_t n = 0;

    for (int i = 0; i < 3; i++)
        v[i] = (struct etch_point_q16){to_q16(x[o[i]]), to_q16(y[o[i]])};
    oracle_triangle_make(&exact, x, y);
    test_canvas_wipe(&canvas);
    etch_triangle_fill_q16(&canvas.surface, v, TEST_INK);
    CHECK_INSIDE(&canvas);
    for (int32_t py = w->y0; py < w->y1; py++)
        for (int32_t px = w->x0; px < w->x1; px++) {
            CHECK_EQ(test_canvas_drawn(&canvas, px, py), oracle_triangle_covers(&exact, px, py));
            n += test_canvas_drawn(&canvas, px, py);
        }
    return n;
}

/* In all six orders of the vertices, with the expected number of pixels. */
static void count(const int32_t x[3], const int32_t y[3], int32_t expected)
{
    for (int order = 0; order < 6; order++)
        if (!CHECK_EQ(draw(x, y, order), expected)) {
            for (int i = 0; i < 3; i++) {
                test_note("x", x[i]);
                test_note("y", y[i]);
            }
            return;
        }
}

/* ---- coordinates ----------------------------------------------------------------------------- */

/* Every three of the points at the ends, in the middle and just beside the ends. */
static void corners_at_the_int16_limits(void)
{
    static const int16_t end[] = {INT16_MIN, -1, 7, INT16_MAX};

    for (int w = 0; w < 2; w++) {
        test_canvas_open(&canvas, windows[w]);
        for (int32_t n = 0; n < TEST_COUNT(4096) && !test_failed(); n++) {
            const int32_t i = n * 1021 % 4096;
            int16_t x[3], y[3];
            int32_t x_q8[3], y_q8[3];
            struct oracle_triangle exact;

            for (int k = 0; k < 3; k++) {
                x[k] = end[i >> 4 * k & 3], y[k] = end[i >> (4 * k + 2) & 3];
                x_q8[k] = (int32_t)x[k] * 256 + 128, y_q8[k] = (int32_t)y[k] * 256 + 128;
            }
            oracle_triangle_make(&exact, x_q8, y_q8);
            test_canvas_wipe(&canvas);
            etch_triangle_fill(&canvas.surface, x[0], y[0], x[1], y[1], x[2], y[2], TEST_INK);
            CHECK_INSIDE(&canvas);
            for (int32_t p = 0; p < 16 * 12; p++) {
                const int32_t px = windows[w].x0 + p % 16, py = windows[w].y0 + p / 16;

                CHECK_EQ(test_canvas_drawn(&canvas, px, py),
                         oracle_triangle_covers(&exact, px, py));
            }
        }
    }
}

/* The least and the greatest 16.16, and the last that is snapped to another 1/256: the greatest
 * goes up to 32768.0. */
static void corners_at_the_q16_limits(void)
{
    static const int32_t end[] = {INT32_MIN, INT32_MIN + 128, INT32_MAX - 128, INT32_MAX};
    static const int32_t end_q8[] = {-8388608, -8388607, 8388607, 8388608};

    for (int w = 0; w < 2; w++) {
        test_canvas_open(&canvas, windows[w]);
        for (int32_t n = 0; n < TEST_COUNT(4096) && !test_failed(); n++) {
            const int32_t i = n * 1021 % 4096;
            struct etch_point_q16 v[3];
            int32_t x[3], y[3];
            struct oracle_triangle exact;

            for (int k = 0; k < 3; k++) {
                v[k].x = end[i >> 4 * k & 3], v[k].y = end[i >> (4 * k + 2) & 3];
                x[k] = end_q8[i >> 4 * k & 3], y[k] = end_q8[i >> (4 * k + 2) & 3];
            }
            oracle_triangle_make(&exact, x, y);
            test_canvas_wipe(&canvas);
            etch_triangle_fill_q16(&canvas.surface, v, TEST_INK);
            CHECK_INSIDE(&canvas);
            for (int32_t p = 0; p < 16 * 12; p++) {
                const int32_t px = windows[w].x0 + p % 16, py = windows[w].y0 + p / 16;

                CHECK_EQ(test_canvas_drawn(&canvas, px, py),
                         oracle_triangle_covers(&exact, px, py));
            }
        }
    }
}

/* ---- no area --------------------------------------------------------------------------------- */

static void no_area_draws_nothing(void)
{
    static const struct test_triangle none[] = {
        {{1152, 1152, 1152}, {1152, 1152, 1152}},          /* three times one pixel centre */
        {{1152, 1152, 2176}, {1152, 1152, 1408}},          /* two vertices equal */
        {{0, 1024, 2048}, {128, 128, 128}},                /* along a row of centres */
        {{128, 128, 128}, {0, 1024, 2048}},                /* down a column of centres */
        {{128, 1152, 2176}, {128, 1152, 2176}},            /* a diagonal of centres */
        {{-8388608, 0, 8388608}, {-8388608, 0, 8388608}},  /* the whole diagonal of the plane */
        {{-8388608, 128, 8388608}, {1152, 1152, 1152}},    /* the whole of a row */
        {{-8388608, 8388608, 8388608}, {1000, 1000, 1000}} /* .. with a duplicate */
    };

    test_canvas_open(&canvas, windows[0]);
    for (unsigned i = 0; i < sizeof(none) / sizeof(none[0]); i++)
        count(none[i].x, none[i].y, 0);
}

/* ---- slivers --------------------------------------------------------------------------------- */

/* A right triangle 32,767 px long and 1/256 px thick, lying (or standing, `turn`) with its long
 * side at `at`, on the side before or behind it. `expected` of the window's centres are on it. */
static void sliver(int32_t at, int32_t thick, bool turn, int32_t expected)
{
    const int32_t along[3] = {-4194304, 4194048, 4194048};
    const int32_t across[3] = {at, at, at + thick};

    count(turn ? across : along, turn ? along : across, expected);
}

/* The long side is a top or left edge on centres: all of them are the triangle's. A bottom or right
 * edge on centres: none. */
static void slivers_on_pixel_centres(void)
{
    test_canvas_open(&canvas, windows[0]);
    sliver(1152, 1, false, 16);
    sliver(1152, -1, false, 0);
    sliver(1152, 1, true, 12);
    sliver(1152, -1, true, 0);
}

/* 1/256 px thick, the slanted side reaches the centres at its end only, which is far away. 2/256 px
 * thick it crosses them half way, at x = -1/2 (or y): the window is all behind that. */
static void slivers_beside_pixel_centres(void)
{
    test_canvas_open(&canvas, windows[0]);
    for (int turn = 0; turn < 2; turn++) {
        sliver(1151, 1, turn == 1, 0);
        sliver(1153, 1, turn == 1, 0);
        sliver(1153, -1, turn == 1, 0);
        sliver(1151, -1, turn == 1, 0);
    }
    sliver(1153, -2, false, 16);
    sliver(1153, -2, true, 12);
    sliver(1151, 2, false, 16);
    sliver(1151, 2, true, 12);
}

static void slivers_between_pixel_centres(void)
{
    test_canvas_open(&canvas, windows[0]);
    for (int turn = 0; turn < 2; turn++)
        for (int32_t at = 1153; at < 1152 + 255; at += 3) {
            sliver(at, 1, turn == 1, 0);
            sliver(at + 1, -1, turn == 1, 0);
        }
}

/* Along the diagonal through centres: it is a left edge of the triangle above it, which has them,
 * and a right edge of the one below. */
static void slivers_along_the_diagonal(void)
{
    const int32_t far = 4194048, x[3] = {128 - far, 128 + far, 128 + far};
    const int32_t above[3] = {128 - far, 128 + far, 127 + far},
                  below[3] = {128 - far, 128 + far, 129 + far};

    test_canvas_open(&canvas, windows[0]);
    count(x, above, 12);
    count(x, below, 0);
    test_canvas_open(&canvas, (struct etch_rect){16370, 16374, 16386, 16386});
    count(x, above, 9); /* up to pixel 16,382: the next has the right side on its centre */
    count(x, below, 0);
}

/* ---- vertices on centres --------------------------------------------------------------------- */

/* Eight triangles that meet in the centre of pixel (8, 6), from all sides: that pixel belongs to
 * the one below and right of it that has it on top or left edges, and every pixel of the square to
 * one. */
static void vertices_on_centres_from_all_sides(void)
{
    static const int8_t dx[] = {4, 4, 0, -4, -4, -4, 0, 4}, dy[] = {0, 4, 4, 4, 0, -4, -4, -4};
    int32_t times[12][16] = {{0}}, owner = -1;

    test_canvas_open(&canvas, windows[0]);
    for (int i = 0; i < 8; i++) {
        const int j = (i + 1) % 8;
        const int32_t x[3] = {2176, 2176 + 256 * dx[i], 2176 + 256 * dx[j]};
        const int32_t y[3] = {1664, 1664 + 256 * dy[i], 1664 + 256 * dy[j]};

        for (int order = 0; order < 6; order++)
            (void)draw(x, y, order);
        for (int32_t p = 0; p < 16 * 12; p++)
            times[p / 16][p % 16] += test_canvas_drawn(&canvas, p % 16, p / 16);
        if (test_canvas_drawn(&canvas, 8, 6))
            owner = i;
    }
    CHECK_EQ(owner, 0); /* from straight right to below right: its upper edge is a top edge */
    for (int32_t p = 0; p < 16 * 12; p++) {
        const int32_t x = p % 16, y = p / 16;

        CHECK_EQ(times[y][x], x >= 4 && x < 12 && y >= 2 && y < 10);
    }
}

/* ---- the whole screen ------------------------------------------------------------------------ */

static void triangles_that_contain_the_screen(void)
{
    static const struct test_triangle round[] = {
        {{-8388608, 8388608, 0}, {-8388608, -8388608, 8388608}},
        {{-8388608, 8388608, 8388608}, {8388608, 8388608, -8388608}},
        {{0, 32 * 256, 0}, {0, 0, 24 * 256}}, /* the least one: its long side passes a corner */
        {{128, 8388608, 128}, {128, 128, 8388608}}, /* first row and column of centres on edges */
    };

    test_canvas_open(&canvas, windows[0]);
    for (unsigned i = 0; i < sizeof(round) / sizeof(round[0]); i++)
        count(round[i].x, round[i].y, 16 * 12);
}

void suite_extremes_triangle(void)
{
    RUN(corners_at_the_int16_limits);
    RUN(corners_at_the_q16_limits);
    RUN(no_area_draws_nothing);
    RUN(slivers_on_pixel_centres);
    RUN(slivers_beside_pixel_centres);
    RUN(slivers_between_pixel_centres);
    RUN(slivers_along_the_diagonal);
    RUN(vertices_on_centres_from_all_sides);
    RUN(triangles_that_contain_the_screen);
}
