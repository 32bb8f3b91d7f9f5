/* tests/unit: cost is proportional to what is visible, counted in basic blocks of core
 * (harness/stores.h): whatever reaches far beyond a small clip costs no more than a bound, or than
 * the same pixels cost by a shape that hardly passes the clip. */
#include "core/draw/shapes.h"
#include "core/draw/triangle.h"
#include "core/fragment/flat.h"
#include "core/fragment/gouraud.h"
#include "core/raster/circle.h"
#include "core/raster/line.h"
#include "core/raster/line_small.h"
#include "core/raster/rect.h"
#include "tests/harness/canvas.h"
#include "tests/harness/stores.h"

void suite_cost(void);

static struct test_canvas canvas;
static int32_t worst; /* blocks of the costliest shape of the running case */

/* An 8 x 8 clip in windows at the origin, in the middle of the frame and in its far corner. */
static const struct etch_rect clips[] = {
    {0, 0, 8, 8}, {23, 7, 31, 15}, {170, 120, 178, 128}, {32759, 32759, 32767, 32767}};

static void open_clip(int32_t i)
{
    static const struct etch_rect windows[] = {
        {0, 0, 8, 8}, {0, 0, 48, 36}, {150, 100, 190, 141}, {32727, 32731, 32767, 32767}};

    test_canvas_open(&canvas, windows[i % 4]);
    test_canvas_clip(&canvas, clips[i % 4]);
    (void)test_blocks();
}

static int32_t pixels_drawn(void)
{
    const struct etch_rect *clip = &canvas.surface.clip;
    int32_t x, y, n = 0;

    for (y = clip->y0; y < clip->y1; y++)
        for (x = clip->x0; x < clip->x1; x++)
            n += test_canvas_drawn(&canvas, x, y);
    return n;
}

/* What was drawn since open_clip ran at most `most` blocks. */
static bool cost_at_most(int32_t most)
{
    const int32_t blocks = (int32_t)test_blocks();

    worst = blocks > worst ? blocks : worst;
    return CHECK(blocks <= most) && CHECK(!TEST_STORES || blocks > 0);
}

static void tell(const char *what)
{
    if (TEST_STORES)
        test_print_count(what, worst, " blocks at most");
    worst = 0;
}

static bool fits(int64_t v)
{
    return v >= INT16_MIN && v <= INT16_MAX;
}

/* Lines from end to end of the plane, along either axis and both ways, that pass a pixel of the
 * clip by less than one. */
static void lines(void (*draw)(const struct etch_surface *, int16_t, int16_t, int16_t, int16_t,
                               uint16_t),
                  int32_t most)
{
    uint32_t seed = 61;
    int32_t i = 0, seen = 0;

    while (i < TEST_COUNT(20000) && !test_failed()) {
        const struct etch_rect *clip = &clips[i % 4];
        const int32_t x = test_range(&seed, clip->x0, clip->x1 - 1);
        const int32_t y = test_range(&seed, clip->y0, clip->y1 - 1);
        const bool steep = i % 3 == 2;
        const int32_t major = steep ? y : x, minor = steep ? x : y;
        const int32_t from = test_range(&seed, INT16_MIN, INT16_MAX);
        const int64_t to = from + ((int64_t)minor - from) * 65535 / (major + 32768);

        if (!fits(to))
            continue;
        open_clip(i++);
        if (steep)
            draw(&canvas.surface, (int16_t)from, INT16_MIN, (int16_t)to, INT16_MAX, TEST_INK);
        else if (i % 3 == 1)
            draw(&canvas.surface, INT16_MIN, (int16_t)from, INT16_MAX, (int16_t)to, TEST_INK);
        else
            draw(&canvas.surface, INT16_MAX, (int16_t)to, INT16_MIN, (int16_t)from, TEST_INK);
        if (!cost_at_most(most)) {
            test_note("from", from);
            test_note("to", to);
        }
        seen += pixels_drawn() > 0;
    }
    CHECK(seen > i / 2);
}

static void long_lines(void)
{
    lines(etch_line_draw, 400);
    tell("lines 65,535 long with up to 8 visible pixels: ");
}

static void long_lines_by_few_bytes(void)
{
    lines(etch_line_draw_small, 400);
    tell("the same by etch_line_draw_small: ");
}

/* floor(sqrt(v)), bit by bit. */
static int32_t root(int64_t v)
{
    int64_t r = 0, bit;

    for (bit = 32768; bit != 0; bit /= 2)
        if ((r + bit) * (r + bit) <= v)
            r += bit;
    return (int32_t)r;
}

/* Circles of radius 32,767 and less whose outline passes a pixel of the clip, by less than two. */
static void circles(void (*draw)(const struct etch_surface *, int16_t, int16_t, int16_t, uint16_t),
                    int32_t most)
{
    uint32_t seed = 62;
    int32_t i = 0, seen = 0;

    while (i < TEST_COUNT(20000) && !test_failed()) {
        const struct etch_rect *clip = &clips[i % 4];
        const int32_t r = test_range(&seed, 0, 1) ? 32767 : test_range(&seed, 20000, 32767);
        const int32_t dx = test_range(&seed, 0, r), dy = root((int64_t)r * r - (int64_t)dx * dx);
        const int32_t x = test_range(&seed, clip->x0, clip->x1 - 1) +
                          (test_range(&seed, 0, 1) ? dx : -dx);
        const int32_t y = test_range(&seed, clip->y0, clip->y1 - 1) +
                          (test_range(&seed, 0, 1) ? dy : -dy);

        if (!fits(x) || !fits(y))
            continue;
        open_clip(i++);
        draw(&canvas.surface, (int16_t)x, (int16_t)y, (int16_t)r, TEST_INK);
        if (!cost_at_most(most)) {
            test_note("x", x);
            test_note("y", y);
            test_note("r", r);
        }
        seen += pixels_drawn() > 0;
    }
    CHECK(seen > i / 2);
}

static void large_circles(void)
{
    circles(etch_circle_draw, 1000);
    tell("circles of radius 20,000 .. 32,767 over 8 x 8 pixels: ");
}

/* A disc follows its outline through the visible rows: sqrt(2 * 32767 * 8) = 724 steps at most. */
static void large_discs(void)
{
    circles(etch_circle_fill, 3000);
    tell("discs of radius 20,000 .. 32,767 over 8 x 8 pixels: ");
}

/* Three ways to fill a triangle. */
static void fill(const struct etch_vertex v[3])
{
    const struct etch_point_q16 p[3] = {{v[0].x_q8 * 256, v[0].y_q8 * 256},
                                        {v[1].x_q8 * 256, v[1].y_q8 * 256},
                                        {v[2].x_q8 * 256, v[2].y_q8 * 256}};

    etch_triangle_fill_q16(&canvas.surface, p, TEST_INK);
}

static void flat_depth(const struct etch_vertex v[3])
{
    const struct etch_vertex *const p[3] = {&v[0], &v[1], &v[2]};

    etch_triangle_flat_depth(&canvas.surface, p, etch_kernel_flat_less);
}

static void gouraud_depth(const struct etch_vertex v[3])
{
    const struct etch_vertex *const p[3] = {&v[0], &v[1], &v[2]};

    etch_triangle_gouraud_depth(&canvas.surface, p, etch_kernel_gouraud_less);
}

static void set(struct etch_vertex *v, int32_t x, int32_t y)
{
    const struct etch_vertex to = {
        x * 256, y * 256, (uint32_t)(x + y + 70000) << 14, (uint8_t)(x & 255), (uint8_t)(y & 255),
        1,       255};

    *v = to;
}

/* Blocks that a triangle runs which just covers the clip. */
static int32_t small_cost(int32_t i, void (*draw)(const struct etch_vertex v[3]))
{
    const struct etch_rect *clip = &clips[i % 4];
    struct etch_vertex v[3];

    set(&v[0], clip->x1, clip->y1);
    set(&v[1], clip->x1 - 20, clip->y1);
    set(&v[2], clip->x1, clip->y1 - 20);
    open_clip(i);
    draw(v);
    CHECK_EQ(pixels_drawn(), 64);
    return (int32_t)test_blocks();
}

/* Triangles with their corners as far out as they can be, over all of the clip, part of it or
 * beside it; `more` is the part of set-up that a small triangle does without. */
static void triangles(void (*draw)(const struct etch_vertex v[3]), int32_t more)
{
    static const int16_t at[] = {INT16_MIN, INT16_MIN, INT16_MAX, INT16_MAX, 0, 12, 175};
    uint32_t seed = 63;
    int32_t most[4], i, covered = 0;

    for (i = 0; i < 4; i++)
        most[i] = small_cost(i, draw) + more;
    worst = 0;
    for (i = 0; i < TEST_COUNT(20000) && !test_failed(); i++) {
        struct etch_vertex v[3];
        int k;

        for (k = 0; k < 3; k++)
            set(&v[k], at[test_range(&seed, 0, 6)], at[test_range(&seed, 0, 6)]);
        open_clip(i);
        draw(v);
        if (!cost_at_most(most[i % 4])) {
            for (k = 0; k < 3; k++) {
                test_note("x_q8", v[k].x_q8);
                test_note("y_q8", v[k].y_q8);
            }
        }
        covered += pixels_drawn() == 64;
    }
    CHECK(covered > i / 20);
    if (TEST_STORES)
        test_print_count("triangle that just covers 8 x 8 pixels: ", most[0] - more, " blocks");
}

/* Edges start by a division each, and the planes of triangles so large are exact (raster/plane.h):
 * up to 800 blocks each. */
static void huge_triangles(void)
{
    triangles(fill, 400);
    tell("triangles of 65,535 px over them, filled: ");
    triangles(flat_depth, 400 + 800);
    tell("with depth: ");
    triangles(gouraud_depth, 400 + 4 * 800);
    tell("with colour and depth: ");
}

/* Blocks of a triangle that covers a surface of 64 x 48: one that just does, or one of 32,767 px.
 */
static int32_t cover_cost(void (*draw)(const struct etch_vertex v[3]), bool huge)
{
    const struct etch_rect window = {0, 0, 64, 48};
    struct etch_vertex v[3];

    set(&v[0], huge ? -32767 : 0, huge ? 32767 : 0);
    set(&v[1], huge ? 32767 : 112, huge ? 32767 : 0);
    set(&v[2], 0, huge ? -32767 : 112);
    test_canvas_open(&canvas, window);
    (void)test_blocks();
    draw(v);
    CHECK_EQ(pixels_drawn(), 64 * 48);
    return (int32_t)test_blocks();
}

/* One of +-32,767 px costs no more, give or take set-up. */
static void a_triangle_of_32767_px_over_64_by_48(void)
{
    CHECK(cover_cost(fill, true) <= cover_cost(fill, false) + 400);
    CHECK(cover_cost(flat_depth, true) <= cover_cost(flat_depth, false) + 400 + 800);
    CHECK(cover_cost(gouraud_depth, true) <= cover_cost(gouraud_depth, false) + 400 + 4 * 800);
}

/* Outlines of rectangles up to 32,767 px wide round, through and beside the clip. */
static void large_rectangles(void)
{
    uint32_t seed = 64;
    int32_t i;

    for (i = 0; i < TEST_COUNT(20000) && !test_failed(); i++) {
        const struct etch_rect *clip = &clips[i % 4];

        open_clip(i);
        etch_rect_draw(&canvas.surface, (int16_t)test_range(&seed, clip->x0 - 32767, clip->x0 + 7),
                       (int16_t)test_range(&seed, clip->y0 - 32767, clip->y0 + 7),
                       (int16_t)test_range(&seed, 30000, INT16_MAX),
                       (int16_t)test_range(&seed, 30000, INT16_MAX), TEST_INK);
        cost_at_most(400);
    }
    tell("outlines of rectangles 30,000 .. 32,767 px wide: ");
}

void suite_cost(void)
{
    worst = 0;
    RUN(long_lines);
    RUN(long_lines_by_few_bytes);
    RUN(large_circles);
    RUN(large_discs);
    RUN(huge_triangles);
    RUN(a_triangle_of_32767_px_over_64_by_48);
    RUN(large_rectangles);
    if (!TEST_STORES)
        test_print("pixels only; `make stores` counts the blocks");
}
