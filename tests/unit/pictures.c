/* tests/unit: calls beside the pictures that they draw. */
#include "core/draw/shapes.h"
#include "core/draw/triangle.h"
#include "core/raster/circle.h"
#include "core/raster/line.h"
#include "core/raster/rect.h"
#include "tests/harness/canvas.h"

void suite_pictures(void);

static struct test_canvas canvas;
static const struct etch_surface *const surface = &canvas.surface;

/* A fresh canvas of w x h at the origin of the frame. */
static void open(int16_t w, int16_t h)
{
    const struct etch_rect window = {0, 0, w, h};

    test_canvas_open(&canvas, window);
}

static void points(void)
{
    open(4, 2);
    etch_point_draw(surface, 0, 0, 1);
    etch_point_draw(surface, 3, 1, 2);
    etch_point_draw(surface, 4, 1, 3);
    etch_point_draw(surface, -1, 0, 3);
    CHECK_PICTURE(&canvas, "a..."
                           "...b");
    CHECK_ONCE(&canvas);
}

static void line_from_0_0_to_5_2(void)
{
    open(6, 3);
    etch_line_draw(surface, 0, 0, 5, 2, TEST_INK);
    CHECK_PICTURE(&canvas, "##...."
                           "..##.."
                           "....##");
    CHECK_ONCE(&canvas);
}

/* The tie at (1, 1/2) stays on the side of the left end, whichever end comes first. */
static void line_with_a_tie(void)
{
    open(3, 2);
    etch_line_draw(surface, 0, 0, 2, 1, TEST_INK);
    CHECK_PICTURE(&canvas, "##."
                           "..#");
    open(3, 2);
    etch_line_draw(surface, 2, 1, 0, 0, TEST_INK);
    CHECK_PICTURE(&canvas, "##."
                           "..#");
    open(3, 2);
    etch_line_draw(surface, 0, 1, 2, 0, TEST_INK);
    CHECK_PICTURE(&canvas, "..#"
                           "##.");
    open(2, 3);
    etch_line_draw(surface, 1, 2, 0, 0, TEST_INK);
    CHECK_PICTURE(&canvas, "#."
                           "#."
                           ".#");
}

/* A clip shows a part of the same pixels. */
static void line_clipped(void)
{
    const struct etch_rect clip = {1, 0, 5, 2};

    open(6, 3);
    test_canvas_clip(&canvas, clip);
    etch_line_draw(surface, 0, 0, 5, 2, TEST_INK);
    CHECK_PICTURE(&canvas, ".#...."
                           "..##.."
                           "......");
    CHECK_ONCE(&canvas);
}

static void straight_lines(void)
{
    open(6, 4);
    etch_hline_draw(surface, -2, 0, 4, 1);
    etch_vline_draw(surface, 3, 1, 9, 2);
    etch_hline_draw(surface, 0, 2, 0, 3);
    etch_vline_draw(surface, 5, 3, -1, 3);
    CHECK_PICTURE(&canvas, "aa...."
                           "...b.."
                           "...b.."
                           "...b..");
    CHECK_ONCE(&canvas);
}

static void polylines(void)
{
    static const struct etch_point open_ends[] = {{0, 0}, {3, 0}, {3, 2}};
    static const struct etch_point closed[] = {{0, 0}, {4, 0}, {2, 2}, {0, 0}};

    open(5, 3);
    etch_polyline_draw(surface, open_ends, 3, TEST_INK);
    CHECK_PICTURE(&canvas, "####."
                           "...#."
                           "...#.");
    CHECK_ONCE(&canvas);
    open(5, 3);
    etch_polyline_draw(surface, closed, 4, TEST_INK);
    CHECK_PICTURE(&canvas, "#####"
                           ".#.#."
                           "..#..");
    CHECK_ONCE(&canvas);
    open(2, 1);
    etch_polyline_draw(surface, closed, 0, TEST_INK);
    CHECK_PICTURE(&canvas, "..");
    etch_polyline_draw(surface, closed, 1, TEST_INK);
    CHECK_PICTURE(&canvas, "#.");
}

static void rectangles(void)
{
    open(7, 4);
    etch_rect_fill(surface, 1, 1, 2, 2, 1);
    etch_rect_draw(surface, 4, 0, 3, 4, 2);
    etch_rect_fill(surface, 0, 0, 0, 4, 3);
    etch_rect_draw(surface, 0, 0, 4, -1, 3);
    CHECK_PICTURE(&canvas, "....bbb"
                           ".aa.b.b"
                           ".aa.b.b"
                           "....bbb");
    CHECK_ONCE(&canvas);
}

/* One row, one column: the outline is the rectangle, each pixel once. */
static void flat_outlines(void)
{
    open(5, 3);
    etch_rect_draw(surface, 0, 0, 4, 1, 1);
    etch_rect_draw(surface, 4, 0, 1, 3, 2);
    etch_rect_draw(surface, 0, 2, 1, 1, 3);
    etch_rect_draw(surface, 2, 1, 2, 2, 4);
    CHECK_PICTURE(&canvas, "aaaab"
                           "..ddb"
                           "c.ddb");
    CHECK_ONCE(&canvas);
}

static void circles(void)
{
    open(11, 7);
    etch_circle_draw(surface, 1, 1, 0, 1);
    etch_circle_draw(surface, 1, 4, 1, 2);
    etch_circle_draw(surface, 7, 3, 3, 3);
    etch_circle_draw(surface, 5, 3, -1, 4);
    CHECK_PICTURE(&canvas, "......ccc.."
                           ".a...c...c."
                           "....c.....c"
                           ".b..c.....c"
                           "b.b.c.....c"
                           ".b...c...c."
                           "......ccc..");
    CHECK_ONCE(&canvas);
}

static void discs(void)
{
    open(11, 5);
    etch_circle_fill(surface, 0, 0, 0, 1);
    etch_circle_fill(surface, 1, 3, 1, 2);
    etch_circle_fill(surface, 5, 2, 2, 3);
    etch_circle_fill(surface, 11, 2, 2, 4);
    CHECK_PICTURE(&canvas, "a...ccc...d"
                           "...ccccc.dd"
                           ".b.ccccc.dd"
                           "bbbccccc.dd"
                           ".b..ccc...d");
    CHECK_ONCE(&canvas);
}

/* Vertices stand at pixel centres: the top and left edges are drawn, the others are not. */
static void filled_triangles(void)
{
    open(5, 5);
    etch_triangle_fill(surface, 0, 0, 4, 0, 0, 4, TEST_INK);
    CHECK_PICTURE(&canvas, "####."
                           "###.."
                           "##..."
                           "#...."
                           ".....");
    CHECK_ONCE(&canvas);
    open(5, 5);
    etch_triangle_fill(surface, 4, 0, 4, 4, 0, 4, TEST_INK);
    CHECK_PICTURE(&canvas, "....."
                           "...#."
                           "..##."
                           ".###."
                           ".....");
}

/* Two triangles that share an edge meet without gap or overlap. */
static void square_of_two_triangles(void)
{
    open(4, 4);
    etch_triangle_fill(surface, 0, 0, 3, 0, 0, 3, 1);
    etch_triangle_fill(surface, 3, 0, 3, 3, 0, 3, 2);
    CHECK_PICTURE(&canvas, "aaa."
                           "aab."
                           "abb."
                           "....");
    CHECK_ONCE(&canvas);
}

static void triangle_outline(void)
{
    open(5, 5);
    etch_triangle_draw(surface, 0, 0, 4, 0, 0, 4, TEST_INK);
    CHECK_PICTURE(&canvas, "#####"
                           "#..#."
                           "#.#.."
                           "##..."
                           "#....");
    CHECK_ONCE(&canvas);
}

/* 16.16 vertices: the square 1.0 .. 3.0 covers the four pixels whose corners those are; moved by
 * half a pixel its left and top edges go through centres and count, the others do not. */
static void subpixel_triangles(void)
{
    static const etch_q16 one = ETCH_Q16_ONE;
    const struct etch_point_q16 upper[3] = {{one, one}, {3 * one, one}, {one, 3 * one}};
    const struct etch_point_q16 lower[3] = {{3 * one, one}, {3 * one, 3 * one}, {one, 3 * one}};
    const struct etch_point_q16 half[3] = {
        {one / 2, one / 2}, {5 * one / 2, one / 2}, {one / 2, 5 * one / 2}};

    open(4, 4);
    etch_triangle_fill_q16(surface, upper, 1);
    etch_triangle_fill_q16(surface, lower, 2);
    CHECK_PICTURE(&canvas, "...."
                           ".ab."
                           ".bb."
                           "....");
    CHECK_ONCE(&canvas);
    open(4, 4);
    etch_triangle_fill_q16(surface, half, 1);
    CHECK_PICTURE(&canvas, "aa.."
                           "a..."
                           "...."
                           "....");
}

/* A surface that holds the rows 2 and 3 of the frame shows those rows of the picture. */
static void window_of_the_frame(void)
{
    const struct etch_rect rows = {0, 2, 6, 4};

    test_canvas_open(&canvas, rows);
    etch_line_draw(surface, 0, 0, 5, 5, 1);
    etch_rect_fill(surface, 4, 1, 2, 2, 2);
    CHECK_PICTURE(&canvas, "..a.bb"
                           "...a..");
    CHECK_ONCE(&canvas);
}

void suite_pictures(void)
{
    RUN(points);
    RUN(line_from_0_0_to_5_2);
    RUN(line_with_a_tie);
    RUN(line_clipped);
    RUN(straight_lines);
    RUN(polylines);
    RUN(rectangles);
    RUN(flat_outlines);
    RUN(circles);
    RUN(discs);
    RUN(filled_triangles);
    RUN(square_of_two_triangles);
    RUN(triangle_outline);
    RUN(subpixel_triangles);
    RUN(window_of_the_frame);
}
