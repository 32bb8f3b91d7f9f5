/* tests/unit: points, lines and polylines, each pixel against its definition. */
#include "core/raster/line.h"
#include "tests/harness/canvas.h"
#include "tests/harness/stores.h"
#include "tests/oracle/line.h"

void suite_line(void);

static struct test_canvas canvas;

static const struct etch_rect windows[] = {
    {0, 0, 48, 36}, {0, 0, 33, 25}, {150, 100, 190, 141}, {32727, 32731, 32767, 32767}};

/* What a coordinate of the window's axis [lo, hi) is drawn from. */
typedef int16_t picker(uint32_t *seed, int32_t lo, int32_t hi);

static int16_t to_int16(int32_t v)
{
    return (int16_t)(v > INT16_MAX ? INT16_MAX : v < INT16_MIN ? INT16_MIN : v);
}

static int16_t pick_inside(uint32_t *seed, int32_t lo, int32_t hi)
{
    return to_int16(test_range(seed, lo, hi - 1));
}

static int16_t pick_near(uint32_t *seed, int32_t lo, int32_t hi)
{
    return to_int16(test_range(seed, lo - 40, hi + 40));
}

static int16_t pick_far(uint32_t *seed, int32_t lo, int32_t hi)
{
    switch (test_range(seed, 0, 5)) {
    case 0: return INT16_MIN;
    case 1: return INT16_MAX;
    case 2: return pick_inside(seed, lo, hi);
    case 3: return pick_near(seed, lo, hi);
    default: return to_int16(test_range(seed, INT16_MIN, INT16_MAX));
    }
}

/* A window and a clip that cuts it every other time. */
static void open_window(uint32_t *seed, int32_t i)
{
    const struct etch_rect w = windows[i % 4];
    struct etch_rect clip = w;

    test_canvas_open(&canvas, w);
    if (i % 8 < 4)
        return;
    clip.x0 = (int16_t)test_range(seed, w.x0, w.x1 - 1);
    clip.y0 = (int16_t)test_range(seed, w.y0, w.y1 - 1);
    clip.x1 = (int16_t)test_range(seed, clip.x0, w.x1);
    clip.y1 = (int16_t)test_range(seed, clip.y0, w.y1);
    test_canvas_clip(&canvas, clip);
}

static void note_points(const struct etch_point *p, size_t n)
{
    size_t i;

    for (i = 0; i < n; i++) {
        test_note("x", p[i].x);
        test_note("y", p[i].y);
    }
}

/* The canvas holds the line and nothing else. */
static void compare(const struct etch_point p[2])
{
    const struct etch_rect clip = canvas.surface.clip;
    int32_t x, y, wrong = 0;

    for (y = clip.y0; y < clip.y1; y++)
        for (x = clip.x0; x < clip.x1; x++)
            wrong += oracle_line_covers(p[0].x, p[0].y, p[1].x, p[1].y, x, y) !=
                     test_canvas_drawn(&canvas, x, y);
    if (!CHECK_EQ(wrong, 0))
        note_points(p, 2);
    CHECK_ONCE(&canvas);
}

/* Draws a line and compares, then back to front: the same pixels. */
static void try_line(const struct etch_point p[2])
{
    uint32_t forth;

    etch_line_draw(&canvas.surface, p[0].x, p[0].y, p[1].x, p[1].y, TEST_INK);
    compare(p);
    forth = test_canvas_hash(&canvas);
    test_canvas_wipe(&canvas);
    etch_line_draw(&canvas.surface, p[1].x, p[1].y, p[0].x, p[0].y, TEST_INK);
    if (!CHECK_EQ(test_canvas_hash(&canvas), forth))
        note_points(p, 2);
}

static void draw_lines(picker *pick, uint32_t seed)
{
    int32_t i;

    for (i = 0; i < TEST_COUNT(25000) && !test_failed(); i++) {
        const struct etch_rect w = windows[i % 4];
        struct etch_point p[2];
        int k;

        open_window(&seed, i);
        for (k = 0; k < 2; k++) {
            p[k].x = pick(&seed, w.x0, w.x1);
            p[k].y = pick(&seed, w.y0, w.y1);
        }
        try_line(p);
    }
}

static void lines_inside(void)
{
    draw_lines(pick_inside, 1);
}

static void lines_clipped(void)
{
    draw_lines(pick_near, 2);
}

static void lines_far(void)
{
    draw_lines(pick_far, 3);
}

/* Slopes m / 2k with odd m pass exactly between two pixels again and again. */
static void lines_full_of_ties(void)
{
    uint32_t seed = 4;
    int32_t i;

    for (i = 0; i < TEST_COUNT(25000) && !test_failed(); i++) {
        const struct etch_rect w = windows[i % 4];
        const int32_t k = test_range(&seed, 1, 12), m = 2 * test_range(&seed, 0, k - 1) + 1;
        const int32_t times = test_range(&seed, 1, i % 16 == 0 ? 32767 / (2 * k) : 5);
        const int32_t major = 2 * k * times, minor = m * times;
        const int32_t x0 = test_range(&seed, w.x0 - 20, w.x1),
                      y0 = test_range(&seed, w.y0 - 20, w.y1);
        const int32_t across = test_range(&seed, 0, 1) ? major : minor;
        const int32_t x1 = x0 + (test_range(&seed, 0, 1) ? across : -across);
        const int32_t y1 = y0 + (test_range(&seed, 0, 1) ? 1 : -1) * (major + minor - across);
        const struct etch_point p[2] = {{to_int16(x0), to_int16(y0)}, {to_int16(x1), to_int16(y1)}};

        open_window(&seed, i);
        try_line(p);
    }
}

/* Lines 65,535 long: the corners of the plane to one another and through the window. */
static void longest_lines(void)
{
    static const int16_t ends[] = {INT16_MIN, INT16_MIN + 1, -1,       0, 1,
                                   17,        INT16_MAX - 1, INT16_MAX};
    int i;

    for (i = 0; i < 8 * 8 * 8 * 8 && !test_failed(); i++) {
        const struct etch_point p[2] = {{ends[i & 7], ends[i >> 3 & 7]},
                                        {ends[i >> 6 & 7], ends[i >> 9 & 7]}};

        test_canvas_open(&canvas, windows[i % 4]);
        try_line(p);
    }
}

/* Points, horizontal and vertical runs: every size, also beyond the ends of int16. */
static void points_and_straight_lines(void)
{
    uint32_t seed = 9;
    int32_t i;

    for (i = 0; i < TEST_COUNT(20000) && !test_failed(); i++) {
        const struct etch_rect w = windows[i % 4];
        const int16_t x = pick_far(&seed, w.x0, w.x1), y = pick_far(&seed, w.y0, w.y1);
        const int16_t n = pick_far(&seed, -2, 60);
        const int32_t last = (int32_t)(n - 1);
        const int kind = i % 3;
        const struct etch_rect *clip = &canvas.surface.clip;
        int32_t px, py, wrong = 0;

        open_window(&seed, i);
        if (kind == 0)
            etch_point_draw(&canvas.surface, x, y, TEST_INK);
        else if (kind == 1)
            etch_hline_draw(&canvas.surface, x, y, n, TEST_INK);
        else
            etch_vline_draw(&canvas.surface, x, y, n, TEST_INK);
        for (py = clip->y0; py < clip->y1; py++) {
            for (px = clip->x0; px < clip->x1; px++) {
                const int32_t across = kind == 1 ? last : 0, down = kind == 2 ? last : 0;

                wrong += (px >= x && px <= x + across && py >= y && py <= y + down) !=
                         test_canvas_drawn(&canvas, px, py);
            }
        }
        if (!CHECK_EQ(wrong, 0)) {
            test_note("x", x);
            test_note("y", y);
            test_note("n", n);
        }
        CHECK_ONCE(&canvas);
    }
}

/* How often a polyline writes a pixel: once for each line through it, less its joints. */
static int32_t times_written(const struct etch_point *p, size_t n, int32_t x, int32_t y)
{
    int32_t lines = 0, joints = 0;
    size_t i;

    if (n == 1)
        return p[0].x == x && p[0].y == y;
    for (i = 0; i + 1 < n; i++) {
        lines += oracle_line_covers(p[i].x, p[i].y, p[i + 1].x, p[i + 1].y, x, y);
        joints += i > 0 && p[i].x == x && p[i].y == y;
    }
    if (n > 1 && p[0].x == p[n - 1].x && p[0].y == p[n - 1].y)
        joints += p[0].x == x && p[0].y == y;
    return lines > 0 && lines == joints ? 1 : lines - joints; /* all points equal: once */
}

static void compare_polyline(const struct etch_point *p, size_t n)
{
    const struct etch_rect clip = canvas.surface.clip;
    int32_t x, y, wrong = 0, miscounted = 0;

    for (y = clip.y0; y < clip.y1; y++) {
        for (x = clip.x0; x < clip.x1; x++) {
            const int32_t times = times_written(p, n, x, y);
            const size_t at = etch_surface_index(&canvas.surface, (int16_t)x, (int16_t)y);

            wrong += (times > 0) != test_canvas_drawn(&canvas, x, y);
            miscounted += TEST_STORES && canvas.stores[at] != times;
        }
    }
    if (!CHECK_EQ(wrong, 0) || !CHECK_EQ(miscounted, 0))
        note_points(p, n);
    CHECK_INSIDE(&canvas);
}

/* Open and closed, with repeated points, near and far. */
static void polylines_write_joints_once(void)
{
    uint32_t seed = 12;
    int32_t i;

    for (i = 0; i < TEST_COUNT(10000) && !test_failed(); i++) {
        const struct etch_rect w = windows[i % 4];
        const size_t n = (size_t)test_range(&seed, 0, 6);
        picker *pick = i % 5 == 0 ? pick_far : i % 5 == 1 ? pick_near : pick_inside;
        struct etch_point p[7];
        size_t k;

        open_window(&seed, i);
        for (k = 0; k < n; k++) {
            p[k].x = pick(&seed, w.x0, w.x1);
            p[k].y = pick(&seed, w.y0, w.y1);
            if (k > 0 && test_range(&seed, 0, 5) == 0)
                p[k] = p[k - 1];
        }
        if (n > 1 && test_range(&seed, 0, 1))
            p[n - 1] = p[0];
        etch_polyline_draw(&canvas.surface, p, n, TEST_INK);
        compare_polyline(p, n);
        p[n] = p[0];
        test_canvas_wipe(&canvas);
        etch_polygon_draw(&canvas.surface, p, n, TEST_INK);
        compare_polyline(p, n > 0 ? n + 1 : 0);
    }
}

void suite_line(void)
{
    RUN(lines_inside);
    RUN(lines_full_of_ties);
    RUN(lines_clipped);
    RUN(lines_far);
    RUN(longest_lines);
    RUN(points_and_straight_lines);
    RUN(polylines_write_joints_once);
    test_print_count("", TEST_COUNT(25000) * 4 + 4096,
                     " lines, each in both directions, no differing pixel");
}
