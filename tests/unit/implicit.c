/* tests/unit: implicit shapes and quadrics: exactly the pixels where F < 0, asked at each. */
#include "core/raster/implicit.h"
#include "core/raster/quadric.h"
#include "tests/harness/bands.h"

void suite_implicit(void);

static struct test_canvas canvas;
static int32_t asked; /* how often a value was wanted */

/* Discs joined: F = min over some circles of dx^2 + dy^2 - r^2, in int32. */
struct blobs {
    struct etch_implicit shape; /* first */
    int32_t n, x[3], y[3], r[3];
};

static int32_t blob_value(const struct etch_implicit *shape, int16_t x, int16_t y)
{
    const struct blobs *b = (const struct blobs *)(const void *)shape;
    int32_t least = INT32_MAX, i;

    asked++;
    for (i = 0; i < b->n; i++) {
        const int32_t dx = x - b->x[i], dy = y - b->y[i], v = dx * dx + dy * dy - b->r[i] * b->r[i];

        least = v < least ? v : least;
    }
    return least;
}

/* A side function that knows nothing, one that is exact, and one that forgets at random. */
static enum etch_implicit_side unknown(const struct etch_implicit *shape, struct etch_rect tile)
{
    (void)shape;
    CHECK(!etch_rect_is_empty(tile));
    return ETCH_IMPLICIT_UNKNOWN;
}

static enum etch_implicit_side exact(const struct etch_implicit *shape, struct etch_rect tile)
{
    int32_t least = INT32_MAX, most = INT32_MIN;
    int16_t x, y;

    for (y = tile.y0; y < tile.y1; y++) {
        for (x = tile.x0; x < tile.x1; x++) {
            const int32_t v = blob_value(shape, x, y);

            least = v < least ? v : least;
            most = v > most ? v : most;
        }
    }
    return etch_implicit_side_bounds(least, most);
}

static uint32_t forget = 9;

static enum etch_implicit_side forgetful(const struct etch_implicit *shape, struct etch_rect tile)
{
    return test_range(&forget, 0, 2) == 0 ? ETCH_IMPLICIT_UNKNOWN : exact(shape, tile);
}

static void compare(const struct blobs *b)
{
    const struct etch_rect c = canvas.surface.clip, box = b->shape.box;
    struct test_run_log log;
    const struct test_run_paint paint = test_tile_paint(&log, TEST_INK);
    int32_t x, y, wrong = 0;

    etch_implicit_runs(&canvas.surface, &b->shape, &paint.paint);
    CHECK(!log.broken);
    for (y = c.y0; y < c.y1; y++)
        for (x = c.x0; x < c.x1; x++)
            wrong += test_canvas_drawn(&canvas, x, y) !=
                     (blob_value(&b->shape, (int16_t)x, (int16_t)y) < 0 && x >= box.x0 &&
                      x < box.x1 && y >= box.y0 && y < box.y1);
    CHECK_EQ(wrong, 0);
    CHECK_INSIDE(&canvas);
}

static void covers_where_the_function_is_below_zero(void)
{
    static const struct etch_rect windows[] = {{0, 0, 64, 48}, {5, 9, 64, 44}, {31, 33, 64, 48}};
    uint32_t seed = 1;
    int32_t i, k;

    for (i = 0; i < TEST_COUNT(1200) && !test_failed(); i++) {
        struct blobs b = {{blob_value, NULL, 0, {0, 0, 200, 200}}, 0, {0}, {0}, {0}};

        b.n = test_range(&seed, 0, 3);
        for (k = 0; k < b.n; k++) {
            b.x[k] = test_range(&seed, -20, 80);
            b.y[k] = test_range(&seed, -20, 70);
            b.r[k] = test_range(&seed, 0, 60);
        }
        b.shape.side = i % 4 == 0   ? unknown
                       : i % 4 == 1 ? exact
                       : i % 4 == 2 ? forgetful
                                    : etch_implicit_side_slope;
        b.shape.slope = 2 * 120 + 1; /* of dx^2 for |dx| <= 120 */
        if (test_range(&seed, 0, 2) == 0)
            b.shape.box = (struct etch_rect){7, 3, (int16_t)test_range(&seed, 7, 64), 41};
        test_canvas_open(&canvas, windows[i % 3]);
        compare(&b);
    }
}

/* A large disc: few values are asked, and none twice as many as the frame has pixels. */
static void slopes_save_values(void)
{
    struct blobs b = {{blob_value, etch_implicit_side_slope, 2 * 120 + 1, {0, 0, 64, 48}},
                      1,
                      {20, 0, 0},
                      {20, 0, 0},
                      {100, 0, 0}};
    struct test_run_log log;
    const struct test_run_paint paint = test_tile_paint(&log, TEST_INK);

    test_canvas_open(&canvas, (struct etch_rect){0, 0, 64, 48});
    asked = 0;
    etch_implicit_runs(&canvas.surface, &b.shape, &paint.paint);
    CHECK_EQ(log.pixels, 64 * 48);
    CHECK(asked < 40);
    b.r[0] = 1;
    b.x[0] = -110, b.y[0] = -90;
    b.shape.slope = 2 * 200 + 1;
    asked = 0;
    etch_implicit_runs(&canvas.surface, &b.shape, &paint.paint);
    CHECK_EQ(log.pixels, 64 * 48);
    CHECK(asked < 40);
}

/* ---- quadrics -------------------------------------------------------------------------------- */

static int32_t quadrics;

static void compare_quadric(const struct etch_quadric *q)
{
    const struct etch_rect c = canvas.surface.clip;
    struct test_run_log log;
    const struct test_run_paint paint = test_band_paint(&log, TEST_INK);
    int32_t wrong = 0;
    int64_t x, y;

    CHECK_EQ(etch_quadric_check(q), ETCH_OK);
    etch_quadric_runs(&canvas.surface, q, &paint.paint);
    for (y = c.y0; y < c.y1; y++)
        for (x = c.x0; x < c.x1; x++)
            wrong += test_canvas_drawn(&canvas, (int32_t)x, (int32_t)y) !=
                     (q->a * x * x + q->b * x * y + q->c * y * y + q->d * x + q->e * y + q->f < 0);
    if (!CHECK_EQ(wrong, 0)) {
        test_note("a", q->a), test_note("b", q->b), test_note("c", q->c);
        test_note("d", q->d), test_note("e", q->e), test_note("f", q->f);
    }
    CHECK(!log.broken);
    CHECK_INSIDE(&canvas);
    quadrics++;
}

/* With the middle at (mx, my): a (x - mx)^2 + b (x - mx)(y - my) + c (y - my)^2 - f. */
static void covers_conics_of_every_kind(void)
{
    static const struct etch_rect windows[] = {
        {0, 0, 64, 48}, {5, 9, 44, 31}, {32703, 32719, 32767, 32767}};
    uint32_t seed = 3;
    int32_t i;

    for (i = 0; i < TEST_COUNT(4000) && !test_failed(); i++) {
        const struct etch_rect w = windows[i % 3];
        const int64_t mx = test_range(&seed, w.x0 - 9, w.x1 + 9);
        const int64_t my = test_range(&seed, w.y0 - 9, w.y1 + 9);
        const int32_t most = i % 2 != 0 ? 9 : 9000;
        struct etch_quadric q = {test_range(&seed, -most, most),
                                 test_range(&seed, -most, most),
                                 test_range(&seed, -most, most),
                                 0,
                                 0,
                                 0};

        q.d = -2 * q.a * mx - q.b * my + (i % 5 == 0 ? test_range(&seed, -most, most) : 0);
        q.e = -2 * q.c * my - q.b * mx;
        q.f = q.a * mx * mx + q.b * mx * my + q.c * my * my +
              (int64_t)test_range(&seed, -1000, 1000) * most;
        test_canvas_open(&canvas, w);
        compare_quadric(&q);
    }
}

static void coefficients_reach_their_ranges(void)
{
    static const struct etch_rect windows[] = {{0, 0, 64, 48}, {32703, 32719, 32767, 32767}};
    const int64_t most[] = {INT64_C(1) << 30, INT64_C(1) << 44, INT64_C(1) << 61};
    int32_t i;

    for (i = 0; i < 128; i++) {
        const struct etch_quadric q = {
            (int32_t)(i & 1 ? most[0] : -most[0]), (int32_t)(i & 2 ? most[0] : -most[0]),
            (int32_t)(i & 4 ? most[0] : -most[0]), i & 8 ? most[1] : -most[1],
            i & 16 ? most[1] : -most[1],           i & 32 ? most[2] : -most[2]};

        test_canvas_open(&canvas, windows[i >> 6]);
        compare_quadric(&q);
    }
    for (i = 0; i < 6; i++) {
        struct etch_quadric q = {0, 0, 0, 0, 0, 0};

        *(i == 0 ? &q.a : i == 1 ? &q.b : &q.c) = i < 3 ? -(1 << 30) - 1 : 0;
        *(i == 3 ? &q.d : i == 4 ? &q.e : &q.f) = i < 3 ? 0 : most[i < 5 ? 1 : 2] + 1;
        CHECK_EQ(etch_quadric_check(&q), ETCH_EINVAL);
    }
}

/* Parabolas that reach zero, or go below it, at one pixel, wherever that is among the 16 that are
 * scanned at a time. */
static void conics_that_touch_zero_at_a_pixel(void)
{
    test_canvas_open(&canvas, (struct etch_rect){0, 0, 64, 2});
    for (int32_t x = 0; x < 64; x++) {
        const struct etch_quadric gap = {-1, 0, 0, 2 * x, 0, -x * x}; /* -(X - x)^2 */
        const struct etch_quadric dot = {1, 0, 0, -2 * x, 0, x * x - 1};

        test_canvas_wipe(&canvas);
        compare_quadric(&gap);
        test_canvas_wipe(&canvas);
        compare_quadric(&dot);
    }
}

static void an_ellipse_and_a_hyperbola(void)
{
    static const struct etch_quadric ellipse = {4, 0, 16, -48, -128, 272}; /* round (6, 4) */
    static const struct etch_quadric hyperbola = {-4, 0, 9, 48, -72, 36};

    test_canvas_open(&canvas, (struct etch_rect){0, 0, 13, 9});
    compare_quadric(&ellipse);
    CHECK_PICTURE(&canvas, "............."
                           "............."
                           "...#######..."
                           ".###########."
                           ".###########."
                           ".###########."
                           "...#######..."
                           "............."
                           ".............");
    test_canvas_wipe(&canvas);
    compare_quadric(&hyperbola);
    CHECK_PICTURE(&canvas, "............."
                           "#...........#"
                           "##.........##"
                           "###.......###"
                           "###.......###"
                           "###.......###"
                           "##.........##"
                           "#...........#"
                           ".............");
}

void suite_implicit(void)
{
    RUN(covers_where_the_function_is_below_zero);
    RUN(slopes_save_values);
    RUN(covers_conics_of_every_kind);
    RUN(coefficients_reach_their_ranges);
    RUN(conics_that_touch_zero_at_a_pixel);
    RUN(an_ellipse_and_a_hyperbola);
    test_print_count("", quadrics, " quadrics, no differing pixel");
}
