/* tests/unit: circles and discs against their definition. */
#include "core/draw/shapes.h"
#include "core/draw/shapes_small.h"
#include "core/raster/circle.h"
#include "tests/harness/canvas.h"
#include "tests/oracle/circle.h"

void suite_circle(void);

static struct test_canvas canvas;
static int32_t circles, radii;

struct circle {
    int16_t x, y, r;
};

static void note_circle(struct circle c)
{
    test_note("x", c.x);
    test_note("y", c.y);
    test_note("r", c.r);
}

/* The outline, directly. */
static void draw_outline(struct circle c)
{
    etch_circle_draw(&canvas.surface, c.x, c.y, c.r, TEST_INK);
}

static void draw_outline_small(struct circle c)
{
    etch_circle_draw_small(&canvas.surface, c.x, c.y, c.r, TEST_INK);
}

/* The disc through its runs, whose contract is checked. */
static void draw_disc_runs(struct circle c)
{
    struct test_run_log log;
    const struct test_run_paint paint = test_run_paint(&log, TEST_INK);

    etch_circle_runs(&canvas.surface, c.x, c.y, c.r, &paint.paint);
    CHECK(!log.broken);
}

/* The disc in one call. */
static void draw_disc(struct circle c)
{
    etch_circle_fill(&canvas.surface, c.x, c.y, c.r, TEST_INK);
}

typedef void drawer(struct circle c);
typedef bool coverage(int32_t r, int32_t dx, int32_t dy);

static const struct {
    drawer *draw;
    coverage *covers;
} kinds[] = {{draw_outline, oracle_circle_covers},
             {draw_outline_small, oracle_circle_covers},
             {draw_disc_runs, oracle_disc_covers},
             {draw_disc, oracle_disc_covers}};

#define KINDS (int)(sizeof kinds / sizeof *kinds)

/* Draws on the wiped canvas and compares its clip. */
static void try_kind(int kind, struct circle c)
{
    const struct etch_rect clip = canvas.surface.clip;
    int32_t x, y, wrong = 0;

    kinds[kind].draw(c);
    for (y = clip.y0; y < clip.y1; y++)
        for (x = clip.x0; x < clip.x1; x++)
            wrong += kinds[kind].covers(c.r, x - c.x, y - c.y) != test_canvas_drawn(&canvas, x, y);
    if (!CHECK_EQ(wrong, 0))
        note_circle(c);
    CHECK_ONCE(&canvas);
    circles++;
}

/* The oracle's disc is what its rows say: up to the outermost pixel of the outline in the row. */
static void oracle_disc_fills_the_oracle_outline(void)
{
    int32_t r, x, y, outer;

    for (r = 0; r <= 60; r++) {
        for (y = -r - 1; y <= r + 1; y++) {
            for (outer = r + 1; outer >= 0 && !oracle_circle_covers(r, outer, y); outer--)
                continue;
            for (x = -r - 2; x <= r + 2; x++)
                CHECK_EQ(oracle_disc_covers(r, x, y), (x < 0 ? -x : x) <= outer);
        }
    }
}

/* Every radius 0 .. 500, each kind over the whole circle, window by window. */
static void every_radius_to_500(void)
{
    int16_t r, x, y;

    for (r = 0; r <= 500 && !test_failed(); r = (int16_t)(r + TEST_DIVISOR)) {
        const struct circle c = {(int16_t)(r + 1), (int16_t)(r + 2), r};
        const int16_t size = (int16_t)(2 * r + 5);

        radii++;
        for (y = 0; y < size; y = (int16_t)(y + 48)) {
            for (x = 0; x < size; x = (int16_t)(x + 64)) {
                const struct etch_rect window = {x, y, (int16_t)(x + 64), (int16_t)(y + 48)};
                int kind;

                test_canvas_open(&canvas, window);
                for (kind = 0; kind < KINDS; kind++) {
                    test_canvas_wipe(&canvas);
                    try_kind(kind, c);
                }
            }
        }
    }
}

/* The distance r away from a window coordinate, so that the arc passes there. */
static int16_t beside(uint32_t *seed, int32_t at, int32_t r)
{
    const int32_t far = r < 40 ? r : r - test_range(seed, 0, test_range(seed, 0, 1) ? 40 : r);
    const int32_t v = test_range(seed, 0, 1) ? at - far : at + far;

    return (int16_t)(v > INT16_MAX ? INT16_MAX : v < INT16_MIN ? INT16_MIN : v);
}

/* Radii to 32,767 whose arcs cross the window, and centres anywhere. */
static void clipped_circles(void)
{
    uint32_t seed = 3;
    int32_t i;

    for (i = 0; i < TEST_COUNT(3000) && !test_failed(); i++) {
        const struct etch_rect w = {(int16_t)(i % 3 * 300), (int16_t)(i % 2 * 32700),
                                    (int16_t)(i % 3 * 300 + 48), (int16_t)(i % 2 * 32700 + 40)};
        struct etch_rect clip = w;
        struct circle c;
        int kind;

        c.r = (int16_t)test_range(&seed, 0, i % 4 == 0 ? INT16_MAX : i % 4 == 1 ? 3000 : 80);
        if (i % 50 == 0)
            c.r = (int16_t)(INT16_MAX - test_range(&seed, 0, 2));
        c.x = beside(&seed, test_range(&seed, w.x0, w.x1), c.r);
        c.y = test_range(&seed, 0, 1) ? (int16_t)test_range(&seed, w.y0, w.y1)
                                      : beside(&seed, test_range(&seed, w.y0, w.y1), c.r);
        test_canvas_open(&canvas, w);
        clip.x0 = (int16_t)(clip.x0 + test_range(&seed, 0, 12));
        clip.y1 = (int16_t)(clip.y1 - test_range(&seed, 0, 12));
        for (kind = 0; kind < KINDS; kind++) {
            test_canvas_clip(&canvas, clip);
            try_kind(kind, c);
        }
    }
}

/* Radius 32,767 and the ends of int16, where sums leave 16 bits. */
static void circles_at_the_ends(void)
{
    static const int16_t ends[] = {INT16_MIN, -1, 0, 20, INT16_MAX};
    static const int16_t radius[] = {INT16_MIN, -1, 0, 1, 2, 32766, INT16_MAX};
    const struct etch_rect origin = {0, 0, 40, 30};
    int i, kind;

    for (i = 0; i < 5 * 5 * 7; i++) {
        const struct circle c = {ends[i % 5], ends[i / 5 % 5], radius[i / 25]};

        test_canvas_open(&canvas, origin);
        for (kind = 0; kind < KINDS; kind++) {
            test_canvas_wipe(&canvas);
            try_kind(kind, c);
        }
    }
}

void suite_circle(void)
{
    circles = 0;
    radii = 0;
    RUN(oracle_disc_fills_the_oracle_outline);
    RUN(every_radius_to_500);
    RUN(clipped_circles);
    RUN(circles_at_the_ends);
    test_print_count("", radii, " radii from 0 to 500 over the whole circle");
    test_print_count("", circles, " circles and discs on a window, no differing pixel");
}
