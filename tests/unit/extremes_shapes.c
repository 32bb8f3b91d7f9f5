/* tests/unit: lines and circles at the extremes: from end to end of the plane, ties, reversed,
 * radii from the least to the greatest. Each against its definition, pixel by pixel.
 * tests/EXTREMES.md lists what is where. */
#include "core/draw/round.h"
#include "core/draw/shapes.h"
#include "core/raster/circle.h"
#include "core/draw/shapes_small.h"
#include "core/raster/line.h"
#include "core/raster/line_small.h"
#include "tests/harness/canvas.h"
#include "tests/oracle/circle.h"
#include "tests/oracle/line.h"

void suite_extremes_shapes(void);

static struct test_canvas canvas;

/* ---- lines ----------------------------------------------------------------------------------- */

typedef void line_function(const struct etch_surface *s, int16_t x0, int16_t y0, int16_t x1,
                           int16_t y1, uint16_t color);

/* Draws from a to b by every function of lines and compares the window with the definition. Returns
 * the number of pixels. */
static int32_t line(struct etch_point a, struct etch_point b)
{
    static line_function *const by[] = {etch_line_draw, etch_line_draw_small};
    const struct etch_rect *w = &canvas.surface.window;
    int32_t n = 0;

    for (int i = 0; i < 2; i++) {
        n = 0;
        test_canvas_wipe(&canvas);
        by[i](&canvas.surface, a.x, a.y, b.x, b.y, TEST_INK);
        CHECK_ONCE(&canvas);
        for (int32_t y = w->y0; y < w->y1; y++)
            for (int32_t x = w->x0; x < w->x1; x++) {
                CHECK_EQ(test_canvas_drawn(&canvas, x, y),
                         oracle_line_covers(a.x, a.y, b.x, b.y, x, y));
                n += test_canvas_drawn(&canvas, x, y);
            }
    }
    return n;
}

/* Both ways, the same number of pixels: which ones, the definition says. */
static void line_count(struct etch_point a, struct etch_point b, int32_t expected)
{
    if (!CHECK_EQ(line(a, b), expected) || !CHECK_EQ(line(b, a), expected)) {
        test_note("from x", a.x);
        test_note("from y", a.y);
        test_note("to x", b.x);
        test_note("to y", b.y);
    }
}

/* Along both diagonals of the plane, its middle row and column, and from every corner to half the
 * opposite side, over windows at the origin and in the far corner. */
static void lines_65535_px_long(void)
{
    static const struct etch_point nw = {INT16_MIN, INT16_MIN}, ne = {INT16_MAX, INT16_MIN},
                                   sw = {INT16_MIN, INT16_MAX}, se = {INT16_MAX, INT16_MAX};
    static const struct etch_rect far = {32735, 32735, 32767, 32767};

    test_canvas_open(&canvas, (struct etch_rect){0, 0, 32, 32});
    line_count(nw, se, 32);
    line_count(ne, sw, 0); /* through (-1, 0) and (0, -1) */
    line_count((struct etch_point){INT16_MIN, 5}, (struct etch_point){INT16_MAX, 5}, 32);
    line_count((struct etch_point){5, INT16_MIN}, (struct etch_point){5, INT16_MAX}, 32);
    line_count((struct etch_point){INT16_MIN, 5}, (struct etch_point){INT16_MAX, 6}, 32);
    line_count((struct etch_point){5, INT16_MIN}, (struct etch_point){6, INT16_MAX}, 32);
    line_count((struct etch_point){INT16_MIN, -16384}, (struct etch_point){INT16_MAX, 16383}, 32);
    line_count((struct etch_point){-16384, INT16_MIN}, (struct etch_point){16383, INT16_MAX}, 32);
    test_canvas_open(&canvas, far);
    line_count(nw, se, 32); /* the last pixel of the frame is 32766 */
    line_count(nw, (struct etch_point){INT16_MAX, INT16_MAX - 1}, 31);
    line_count(sw, se, 0);
    line_count((struct etch_point){0, 0}, se, 32);
}

/* A point is one pixel, also at the ends of the plane. */
static void lines_of_one_pixel(void)
{
    test_canvas_open(&canvas, (struct etch_rect){32735, 32735, 32767, 32767});
    line_count((struct etch_point){32766, 32766}, (struct etch_point){32766, 32766}, 1);
    line_count((struct etch_point){INT16_MAX, INT16_MAX}, (struct etch_point){INT16_MAX, INT16_MAX},
               0);
    line_count((struct etch_point){INT16_MIN, INT16_MIN}, (struct etch_point){INT16_MIN, INT16_MIN},
               0);
}

/* Every second pixel of a line of slope 1/2 is a tie, which goes to the side of the end with the
 * smaller major coordinate, whichever end comes first. */
static void ties_and_reversed(void)
{
    test_canvas_open(&canvas, (struct etch_rect){0, 0, 7, 4});
    for (int reversed = 0; reversed < 2; reversed++) {
        const struct etch_point a = {0, 0}, b = {6, 3};

        line_count(reversed ? b : a, reversed ? a : b, 7);
        CHECK_PICTURE(&canvas, "##....."
                               "..##..."
                               "....##."
                               "......#");
    }
    line_count((struct etch_point){0, 3}, (struct etch_point){6, 0}, 7);
    CHECK_PICTURE(&canvas, "......#"
                           "....##."
                           "..##..."
                           "##.....");
    test_canvas_open(&canvas, (struct etch_rect){0, 0, 32, 24});
    for (int32_t n = 0; n < TEST_COUNT(4096) && !test_failed(); n++) { /* all slopes k / 2 m */
        const int32_t i = n * 1021 % 4096;
        const struct etch_point a = {16, 12};
        const struct etch_point b = {(int16_t)(a.x + 2 * (i % 64 - 32)),
                                     (int16_t)(a.y + i / 64 - 32)};

        (void)line(a, b);
        (void)line(b, a);
    }
}

/* ---- circles --------------------------------------------------------------------------------- */

/* Draws the outlines, fast and small, and the disc, and compares the window with their definitions.
 * Returns the number of pixels of the outline. */
static int32_t circle(int16_t cx, int16_t cy, int16_t r)
{
    const struct etch_rect *w = &canvas.surface.window;
    int32_t n = 0;

    for (int kind = 0; kind < 3; kind++) {
        test_canvas_wipe(&canvas);
        (kind == 0   ? etch_circle_draw
         : kind == 1 ? etch_circle_draw_small
                     : etch_circle_fill)(&canvas.surface, cx, cy, r, TEST_INK);
        CHECK_ONCE(&canvas);
        for (int32_t y = w->y0; y < w->y1; y++)
            for (int32_t x = w->x0; x < w->x1; x++) {
                const bool expected = r >= 0 &&
                                      (kind == 2 ? oracle_disc_covers
                                                 : oracle_circle_covers)(r, x - cx, y - cy);

                CHECK_EQ(test_canvas_drawn(&canvas, x, y), expected);
                n += kind == 0 && expected;
            }
    }
    return n;
}

static void circles_of_the_least_radii(void)
{
    test_canvas_open(&canvas, (struct etch_rect){0, 0, 5, 5});
    CHECK_EQ(circle(2, 2, 0), 1);
    CHECK_EQ(circle(2, 2, 1), 4);
    CHECK_EQ(circle(2, 2, -1), 0);
    CHECK_EQ(circle(2, 2, INT16_MIN), 0);
    etch_circle_draw(&canvas.surface, 2, 2, 1, TEST_INK);
    CHECK_PICTURE(&canvas, "....."
                           "..#.."
                           ".#.#."
                           "..#.."
                           ".....");
    etch_circle_fill(&canvas.surface, 2, 2, 1, TEST_INK);
    CHECK_PICTURE(&canvas, "....."
                           "..#.."
                           ".###."
                           "..#.."
                           ".....");
}

/* Each of the four ends and four diagonals of the circle in turn over the screen; and centres at
 * the ends of the plane, from where it stays away or only touches. */
static void arcs_of_radius_32767_cross_the_screen(void)
{
    static const struct etch_point centre[] = {
        {-32735, 20},     {32767, 20},      {20, -32735},    {20, 32767},      /* its ends */
        {-23150, -23150}, {-23150, 23190},  {23190, -23150}, {23190, 23190},   /* its diagonals */
        {-30000, -13120}, {-13120, -30000}, {-30000, 13170}, {13170, -30000}}; /* between */
    static const struct etch_point away[] = {
        {INT16_MIN, INT16_MIN}, {INT16_MAX, INT16_MAX}, {INT16_MIN, 0}, {0, INT16_MIN}};

    test_canvas_open(&canvas, (struct etch_rect){0, 0, 48, 40});
    for (unsigned i = 0; i < sizeof(centre) / sizeof(centre[0]); i++)
        CHECK(circle(centre[i].x, centre[i].y, INT16_MAX) >= 24);
    for (unsigned i = 0; i < sizeof(away) / sizeof(away[0]); i++)
        CHECK_EQ(circle(away[i].x, away[i].y, INT16_MAX), 0);
    CHECK_EQ(circle(24, 20, INT16_MAX), 0); /* all inside: the disc covers the screen */
}

void suite_extremes_shapes(void)
{
    RUN(lines_65535_px_long);
    RUN(lines_of_one_pixel);
    RUN(ties_and_reversed);
    RUN(circles_of_the_least_radii);
    RUN(arcs_of_radius_32767_cross_the_screen);
}
