/* tests/unit: Bezier curves: points against Bernstein's formula, chords against their flatness. */
#include "core/raster/curve.h"
#include "tests/harness/bands.h"

void suite_curve(void);

enum {
    LIMIT = 1 << 23,
    MOST = 8192
};

static struct etch_point_q8 points[MOST];
static int32_t count;
static struct test_canvas canvas, other;
static int32_t chords;

static void take(void *context, struct etch_point_q8 to)
{
    (void)context;
    if (CHECK(count < MOST))
        points[count++] = to;
}

/* 2^(degree k) times the curve of control values c at i / 2^k. */
static int64_t bernstein(const int32_t c[4], int degree, int64_t i, int k)
{
    const int64_t j = (INT64_C(1) << k) - i;

    return degree == 2
               ? c[0] * j * j + 2 * c[1] * i * j + c[2] * i * i
               : c[0] * j * j * j + 3 * c[1] * j * j * i + 3 * c[2] * j * i * i + c[3] * i * i * i;
}

static void flatten(const struct etch_point_q8 p[4], int degree, int32_t flatness)
{
    count = 0;
    (degree == 2 ? etch_quadratic_flatten : etch_cubic_flatten)(p, flatness, take, NULL);
}

static int bits_of(int32_t n)
{
    int k = 0;

    for (; n > 1; n /= 2)
        k++;
    CHECK_EQ(1 << k, n == 0 ? 0 : count);
    return k;
}

static int64_t rounded(int64_t v, int bits)
{
    return bits == 0 ? v : (v + (INT64_C(1) << (bits - 1))) >> bits;
}

/* Four places in every chord are within the flatness and a unit of the chord, and the next coarser
 * number of chords is not much too fine: a curve of one chord has it for a reason. */
static void check_flatness(const int32_t x[4], const int32_t y[4], int degree, int32_t flatness)
{
    const int k = bits_of(count), fine = k + 2;
    struct etch_point_q8 from = {x[0], y[0]};
    int32_t i, j;

    for (i = 0; i < count; i++) {
        const struct etch_point_q8 to = points[i];

        CHECK_EQ(to.x, rounded(bernstein(x, degree, i + 1, k), degree * k));
        CHECK_EQ(to.y, rounded(bernstein(y, degree, i + 1, k), degree * k));
        for (j = 1; j < 4; j++) { /* in 1/16 of a unit; the chord is at j / 4 of its way */
            const int64_t cx = rounded(16 * bernstein(x, degree, 4 * i + j, fine), degree * fine);
            const int64_t cy = rounded(16 * bernstein(y, degree, 4 * i + j, fine), degree * fine);
            const int64_t dx = cx - 4 * ((4 - j) * (int64_t)from.x + j * (int64_t)to.x);
            const int64_t dy = cy - 4 * ((4 - j) * (int64_t)from.y + j * (int64_t)to.y);
            const int64_t most = 16 * ((int64_t)flatness + 1);

            if (!CHECK(dx * dx + dy * dy <= most * most))
                test_note("chord", i), test_note("of", count);
        }
        from = to;
        chords++;
    }
}

static void chords_are_as_flat_as_asked(void)
{
    uint32_t seed = 1;
    int32_t i, k;

    for (i = 0; i < TEST_COUNT(8000) && !test_failed(); i++) {
        const int degree = 2 + i % 2;
        const int32_t range = 1 << test_range(&seed, 2, 17);
        const int32_t flatness = test_range(&seed, range / 256 + 1, range / 8 + 2);
        struct etch_point_q8 p[4];
        int32_t x[4], y[4];

        for (k = 0; k < 4; k++) {
            x[k] = p[k].x = test_range(&seed, -range, range);
            y[k] = p[k].y = test_range(&seed, -range, range);
        }
        flatten(p, degree, flatness);
        check_flatness(x, y, degree, flatness);
        CHECK_EQ(points[count - 1].x, x[degree]);
        CHECK_EQ(points[count - 1].y, y[degree]);
    }
}

/* The whole range at the greatest number of chords. Control points are multiples of 2^13, so that
 * Bernstein's sums fit 64 bits without that factor. */
static void the_whole_range_is_exact(void)
{
    uint32_t seed = 2;
    int32_t i, k;

    for (i = 0; i < TEST_COUNT(60) && !test_failed(); i++) {
        const int degree = 2 + i % 2;
        struct etch_point_q8 p[4];
        int32_t x[4], y[4], at, wrong = 0;

        for (k = 0; k < 4; k++) {
            x[k] = i < 40 ? (test_range(&seed, 0, 1) != 0 ? 1024 : -1024)
                          : test_range(&seed, -1024, 1024);
            y[k] = test_range(&seed, -1024, 1024);
            p[k].x = x[k] * 8192, p[k].y = y[k] * 8192;
        }
        flatten(p, degree, i % 3 == 0 ? INT32_MIN : 1);
        k = bits_of(count);
        for (at = 0; at < count; at++) {
            const int64_t vx = bernstein(x, degree, at + 1, k) * (degree == 2 ? 8192 : 1);
            const int64_t vy = bernstein(y, degree, at + 1, k) * (degree == 2 ? 8192 : 1);
            const int down = degree * k - (degree == 2 ? 0 : 13);

            wrong += points[at].x != (down < 0 ? vx * (1 << -down) : rounded(vx, down));
            wrong += points[at].y != (down < 0 ? vy * (1 << -down) : rounded(vy, down));
        }
        CHECK_EQ(wrong, 0);
    }
}

static void straight_curves_are_one_chord(void)
{
    const struct etch_point_q8 even[4] = {{0, 0}, {300, 90}, {600, 180}, {900, 270}};
    const struct etch_point_q8 point[4] = {{-LIMIT, 7}, {-LIMIT, 7}, {-LIMIT, 7}, {-LIMIT, 7}};

    flatten(even, 2, 1);
    CHECK_EQ(count, 1);
    flatten(even, 3, 1);
    CHECK_EQ(count, 1);
    CHECK_EQ(points[0].x, 900);
    flatten(point, 3, 1);
    CHECK_EQ(count, 1);
    CHECK_EQ(points[0].x, -LIMIT);
    CHECK_EQ(etch_curve_bits(4 << 20, 1), 10);
    CHECK_EQ(etch_curve_bits((4 << 20) + 1, 1), 11);
    CHECK_EQ(etch_curve_bits(0, 1), 0);
    CHECK_EQ(etch_curve_bits(UINT32_MAX, INT32_MAX), 0);
}

/* A drawn curve is the polyline through the pixels of its points, each pixel of a short one once.
 */
static void curves_draw_their_chords(void)
{
    static struct etch_point line[MOST + 1];
    const struct etch_rect w = {0, 0, 64, 48};
    uint32_t seed = 3;
    int32_t i, k;

    test_canvas_open(&canvas, w);
    test_canvas_open(&other, w);
    for (i = 0; i < TEST_COUNT(2000) && !test_failed(); i++) {
        const int degree = 2 + i % 2;
        const bool far = i % 7 == 0;
        struct etch_point p[4];
        struct etch_point_q8 q[4];

        for (k = 0; k < 4; k++) {
            p[k].x = (int16_t)test_range(&seed, far ? INT16_MIN : -9, far ? INT16_MAX : 73);
            p[k].y = (int16_t)test_range(&seed, far ? INT16_MIN : -9, far ? INT16_MAX : 57);
            q[k].x = p[k].x * 256 + 128, q[k].y = p[k].y * 256 + 128;
        }
        test_canvas_wipe(&other);
        flatten(q, degree, ETCH_CURVE_FLATNESS_Q8);
        line[0] = p[0];
        for (k = 0; k < count; k++) {
            line[k + 1].x = (int16_t)(points[k].x >> 8);
            line[k + 1].y = (int16_t)(points[k].y >> 8);
        }
        etch_polyline_draw(&other.surface, line, (size_t)count + 1, TEST_INK);
        test_canvas_wipe(&canvas);
        (degree == 2 ? etch_quadratic_draw : etch_cubic_draw)(&canvas.surface, p, TEST_INK);
        CHECK_EQ(test_canvas_hash(&canvas), test_canvas_hash(&other));
        CHECK_INSIDE(&canvas);
    }
}

static void a_parabola_and_an_s(void)
{
    static const struct etch_point bow[3] = {{1, 8}, {8, -6}, {15, 8}};
    static const struct etch_point s[4] = {{0, 8}, {16, 12}, {0, -4}, {16, 0}};

    test_canvas_open(&canvas, (struct etch_rect){0, 0, 17, 9});
    etch_quadratic_draw(&canvas.surface, bow, TEST_INK);
    CHECK_ONCE(&canvas);
    CHECK_PICTURE(&canvas, "................."
                           "......#####......"
                           "......#....#....."
                           ".....#......#...."
                           "....#.......#...."
                           "...#.........#..."
                           "..#...........#.."
                           "..#...........#.."
                           ".#.............#.");
    test_canvas_wipe(&canvas);
    etch_cubic_draw(&canvas.surface, s, TEST_INK);
    CHECK_ONCE(&canvas);
    CHECK_PICTURE(&canvas, ".........##....##"
                           "........#........"
                           "........#........"
                           "........#........"
                           "........#........"
                           "........#........"
                           "........#........"
                           "........#........"
                           "##....##.........");
}

/* A contour of curves is the polygon of their points. */
static void contours_take_curves(void)
{
    static struct etch_polygon_edge edges[600];
    struct etch_polygon polygon;
    const struct etch_rect w = {0, 0, 64, 48};
    uint32_t seed = 4;
    int32_t i, k;

    test_canvas_open(&canvas, w);
    test_canvas_open(&other, w);
    for (i = 0; i < TEST_COUNT(1000) && !test_failed(); i++) {
        struct test_run_log log;
        const struct test_run_paint paint = test_band_paint(&log, TEST_INK);
        struct etch_point_q8 p[6];

        for (k = 0; k < 6; k++) {
            p[k].x = test_range(&seed, -2000, 18000);
            p[k].y = test_range(&seed, -2000, 14000);
        }
        p[5] = p[0]; /* a cubic there and a quadratic back */
        etch_polygon_init(&polygon, edges, 600);
        CHECK_EQ(etch_polygon_add_cubic(&polygon, p, 16), ETCH_OK);
        CHECK_EQ(etch_polygon_add_quadratic(&polygon, p + 3, 16), ETCH_OK);
        test_canvas_wipe(&canvas);
        etch_polygon_runs_evenodd(&canvas.surface, &polygon, &paint.paint);
        count = 0;
        etch_cubic_flatten(p, 16, take, NULL);
        etch_quadratic_flatten(p + 3, 16, take, NULL);
        etch_polygon_init(&polygon, edges, 600);
        CHECK_EQ(etch_polygon_add(&polygon, points, (uint16_t)count), ETCH_OK);
        test_canvas_wipe(&other);
        log.next_row = INT32_MIN;
        etch_polygon_runs_evenodd(&other.surface, &polygon, &paint.paint);
        CHECK_EQ(test_canvas_hash(&canvas), test_canvas_hash(&other));
        CHECK(!log.broken);
        etch_polygon_init(&polygon, edges, 0);
        CHECK_EQ(etch_polygon_add_cubic(&polygon, p, 16), ETCH_ENOMEM);
        CHECK_EQ(etch_polygon_add_quadratic(&polygon, p, 16), ETCH_ENOMEM);
    }
}

void suite_curve(void)
{
    RUN(chords_are_as_flat_as_asked);
    RUN(the_whole_range_is_exact);
    RUN(straight_curves_are_one_chord);
    RUN(curves_draw_their_chords);
    RUN(a_parabola_and_an_s);
    RUN(contours_take_curves);
    test_print_count("", chords, " chords within their flatness");
}
