/* tests/unit: rectangles, their outlines and clears against their definition. */
#include "core/base/rect.h"
#include "core/draw/shapes.h"
#include "core/raster/rect.h"
#include "tests/harness/canvas.h"

void suite_rect(void);

static struct test_canvas canvas;

static int16_t pick(uint32_t *seed, int32_t lo, int32_t hi)
{
    static const int16_t ends[] = {INT16_MIN, INT16_MIN + 1, -1, 0, 1, INT16_MAX - 1, INT16_MAX};

    switch (test_range(seed, 0, 7)) {
    case 0: return ends[test_range(seed, 0, 6)];
    case 1: return (int16_t)test_range(seed, INT16_MIN, INT16_MAX);
    default: return (int16_t)test_range(seed, lo, hi);
    }
}

struct box {
    int16_t x, y, w, h;
};

static bool covers(struct box b, int32_t x, int32_t y)
{
    return x >= b.x && x < (int32_t)b.x + b.w && y >= b.y && y < (int32_t)b.y + b.h;
}

static bool on_outline(struct box b, int32_t x, int32_t y)
{
    return covers(b, x, y) &&
           (x == b.x || x == (int32_t)b.x + b.w - 1 || y == b.y || y == (int32_t)b.y + b.h - 1);
}

static void draw_fill(struct box b)
{
    etch_rect_fill(&canvas.surface, b.x, b.y, b.w, b.h, TEST_INK);
}

static void draw_outline(struct box b)
{
    etch_rect_draw(&canvas.surface, b.x, b.y, b.w, b.h, TEST_INK);
}

static void draw_runs(struct box b)
{
    struct test_run_log log;
    const struct test_run_paint paint = test_run_paint(&log, TEST_INK);

    etch_rect_runs(&canvas.surface, etch_rect_from_size(b.x, b.y, b.w, b.h), &paint.paint);
    CHECK(!log.broken);
}

static void try_boxes(void (*draw)(struct box), bool (*expected)(struct box, int32_t, int32_t))
{
    static const struct etch_rect windows[] = {
        {0, 0, 48, 36}, {150, 100, 190, 141}, {32727, 32731, 32767, 32767}};
    uint32_t seed = 21;
    int32_t i, x, y;

    for (i = 0; i < TEST_COUNT(20000) && !test_failed(); i++) {
        const struct etch_rect w = windows[i % 3];
        const struct box b = {pick(&seed, w.x0 - 20, w.x1), pick(&seed, w.y0 - 20, w.y1),
                              pick(&seed, -2, 60), pick(&seed, -2, 60)};
        struct etch_rect clip = w;
        int32_t wrong = 0;

        clip.x0 = (int16_t)(w.x0 + i % 7);
        clip.y1 = (int16_t)(w.y1 - i % 11);
        test_canvas_open(&canvas, w);
        test_canvas_clip(&canvas, clip);
        draw(b);
        for (y = clip.y0; y < clip.y1; y++)
            for (x = clip.x0; x < clip.x1; x++)
                wrong += expected(b, x, y) != test_canvas_drawn(&canvas, x, y);
        if (!CHECK_EQ(wrong, 0)) {
            test_note("x", b.x);
            test_note("y", b.y);
            test_note("w", b.w);
            test_note("h", b.h);
        }
        CHECK_ONCE(&canvas);
    }
}

static void filled(void)
{
    try_boxes(draw_fill, covers);
}

static void outlined(void)
{
    try_boxes(draw_outline, on_outline);
}

static void as_runs(void)
{
    try_boxes(draw_runs, covers);
}

/* Pixels of the clip that do not hold these values. */
static int32_t others(uint16_t color, uint16_t depth)
{
    const struct etch_surface *s = &canvas.surface;
    int32_t x, y, n = 0;

    for (y = s->clip.y0; y < s->clip.y1; y++) {
        for (x = s->clip.x0; x < s->clip.x1; x++) {
            const size_t at = etch_surface_index(s, (int16_t)x, (int16_t)y);

            n += s->pixels[at] != color || s->depth[at] != depth;
        }
    }
    return n;
}

/* Clears fill the clip, colour and depth each by its own call, and touch nothing else; with and
 * without a gap between the rows. */
static void clears_fill_the_clip(void)
{
    const struct etch_rect window = {10, 20, 50, 60};
    uint32_t seed = 2;
    int32_t i;

    for (i = 0; i < TEST_COUNT(2000) && !test_failed(); i++) {
        const struct etch_rect any = {pick(&seed, 0, 60), pick(&seed, 0, 70), pick(&seed, 0, 60),
                                      pick(&seed, 0, 70)};
        const struct etch_rect rows = {10, any.y0, 50, any.y1};

        if (i % 2 == 0)
            test_canvas_open(&canvas, window);
        else
            test_canvas_open_tight(&canvas, window);
        test_canvas_clip(&canvas, i % 3 == 0 ? rows : any);
        etch_surface_clear(&canvas.surface, TEST_INK);
        CHECK_EQ(others(TEST_INK, UINT16_MAX), 0);
        etch_depth_clear(&canvas.surface, 0x1234);
        CHECK_EQ(others(TEST_INK, 0x1234), 0);
        CHECK_ONCE(&canvas);
    }
}

void suite_rect(void)
{
    RUN(filled);
    RUN(outlined);
    RUN(as_runs);
    RUN(clears_fill_the_clip);
    test_print_count("", TEST_COUNT(20000) * 3, " rectangles, no differing pixel");
}
