/* tests/unit: DDA lines against their stated error. */
#include "core/raster/line_dda.h"
#include "tests/harness/canvas.h"
#include "tests/oracle/line.h"
#include "tests/unit/line_parts.h"

void suite_line_dda(void);

static struct test_canvas canvas;

static const struct etch_rect windows[] = {
    {0, 0, 48, 36}, {150, 100, 190, 141}, {32727, 32731, 32767, 32767}};

/* Whether (x, y) may be a pixel of the line: 1/2 + k / 2^17 px off at most, and the oracle's own
 * unless the border of two pixels is as near as k / 2^17. */
static bool is_allowed(const int16_t p[4], int32_t x, int32_t y, bool drawn)
{
    const int32_t d[2] = {p[2] - p[0], p[3] - p[1]}, at[2] = {x, y};
    const int u = (d[1] < 0 ? -d[1] : d[1]) > (d[0] < 0 ? -d[0] : d[0]), v = 1 - u;
    const int first = d[u] < 0 ? 2 : 0;
    const int64_t du = d[u] < 0 ? -d[u] : d[u], k = at[u] - p[first + u];
    const int64_t dv = (int64_t)p[2 - first + v] - p[first + v];
    /* the way from the pixel to the line, in 2^-17 / du px */
    const int64_t off = (du == 0 ? 0 : dv * k * 131072) -
                        ((int64_t)at[v] - p[first + v]) * 131072 * du;
    const int64_t size = off < 0 ? -off : off;

    if (k < 0 || k > du)
        return !drawn;
    if (du == 0)
        return drawn == (at[v] == p[v]);
    if (drawn)
        return size <= (65536 + k) * du;
    return size >= (65536 - k) * du;
}

static int32_t pixels, differ;

static void try_line(const int16_t p[4])
{
    const struct etch_rect clip = canvas.surface.clip;
    uint32_t hash;
    int32_t x, y, wrong = 0;

    etch_line_draw_dda(&canvas.surface, p[0], p[1], p[2], p[3], TEST_INK);
    for (y = clip.y0; y < clip.y1; y++) {
        for (x = clip.x0; x < clip.x1; x++) {
            const bool drawn = test_canvas_drawn(&canvas, x, y);

            wrong += !is_allowed(p, x, y, drawn);
            pixels += drawn;
            differ += drawn && !oracle_line_covers(p[0], p[1], p[2], p[3], x, y);
        }
    }
    CHECK_EQ(wrong, 0);
    CHECK_ONCE(&canvas);
    hash = test_canvas_hash(&canvas);
    test_canvas_wipe(&canvas);
    etch_line_draw_dda(&canvas.surface, p[2], p[3], p[0], p[1], TEST_INK);
    CHECK_EQ(test_canvas_hash(&canvas), hash);
    if (test_failed())
        for (x = 0; x < 4; x++)
            test_note("p", p[x]);
}

static void error_is_stated(void)
{
    uint32_t seed = 1;
    int32_t i;

    pixels = differ = 0;
    for (i = 0; i < TEST_COUNT(40000) && !test_failed(); i++) {
        const struct etch_rect w = windows[i % 3];
        const bool far = i % 2 != 0;
        const int16_t p[4] = {pick(&seed, w.x0, w.x1, far), pick(&seed, w.y0, w.y1, far),
                              pick(&seed, w.x0, w.x1, far), pick(&seed, w.y0, w.y1, far)};

        test_canvas_open(&canvas, w);
        if (i % 4 > 1) {
            const struct etch_rect clip = {(int16_t)(w.x0 + 7), (int16_t)(w.y0 + 3),
                                           (int16_t)(w.x1 - 5), (int16_t)(w.y1 - 9)};
            test_canvas_clip(&canvas, clip);
        }
        try_line(p);
    }
    test_print_count("", pixels, " pixels of DDA lines, none off by more than stated");
    test_print_count("", differ, " of them beside Bresenham's");
}

/* Both ends are drawn, however long the line: clips round one end see it. */
static void ends_are_drawn(void)
{
    uint32_t seed = 2;
    int32_t i;

    for (i = 0; i < TEST_COUNT(10000) && !test_failed(); i++) {
        const struct etch_rect w = windows[i % 3];
        const int16_t x = (int16_t)test_range(&seed, w.x0, w.x1 - 1);
        const int16_t y = (int16_t)test_range(&seed, w.y0, w.y1 - 1);
        const struct etch_rect clip = {x, y, (int16_t)(x + 1), (int16_t)(y + 1)};

        test_canvas_open(&canvas, w);
        test_canvas_clip(&canvas, clip);
        etch_line_draw_dda(&canvas.surface, x, y, pick(&seed, w.x0, w.x1, true),
                           pick(&seed, w.y0, w.y1, true), TEST_INK);
        CHECK(test_canvas_drawn(&canvas, x, y));
        CHECK_INSIDE(&canvas);
    }
}

/* A slope of 16 bits is exact where the line is 2^k + 1 pixels long: Bresenham's pixels, ties too.
 */
static void exact_slopes_are_bresenhams(void)
{
    static const struct etch_rect window = {0, 0, 33, 33};

    test_canvas_open(&canvas, window);
    for (int32_t length = 1; length <= 16; length *= 2) {
        for (int32_t aside = -length; aside <= length && !test_failed(); aside++) {
            const bool steep = aside % 2 != 0;
            const int32_t x0 = steep && aside < 0 ? -aside : 0;
            const int32_t x1 = x0 + (steep ? aside : length), y1 = 16 + (steep ? length : aside);
            int32_t wrong = 0;

            etch_line_draw_dda(&canvas.surface, (int16_t)x0, 16, (int16_t)x1, (int16_t)y1,
                               TEST_INK);
            for (int32_t y = 0; y < 33; y++)
                for (int32_t x = 0; x < 33; x++)
                    wrong += test_canvas_drawn(&canvas, x, y) !=
                             oracle_line_covers(x0, 16, x1, y1, x, y);
            CHECK_EQ(wrong, 0);
            test_canvas_wipe(&canvas);
        }
    }
}

/* Clipping never moves a pixel: each clipped line is the whole one masked. */
static void clips_only_mask(void)
{
    static struct test_canvas whole;
    uint32_t seed = 3;
    int32_t i, x, y;

    for (i = 0; i < TEST_COUNT(5000) && !test_failed(); i++) {
        const struct etch_rect w = windows[i % 3];
        const int16_t p[4] = {pick(&seed, w.x0, w.x1, true), pick(&seed, w.y0, w.y1, true),
                              pick(&seed, w.x0, w.x1, true), pick(&seed, w.y0, w.y1, true)};
        struct etch_rect clip = w;

        clip.x0 = (int16_t)test_range(&seed, w.x0, w.x1 - 1);
        clip.y0 = (int16_t)test_range(&seed, w.y0, w.y1 - 1);
        clip.x1 = (int16_t)test_range(&seed, clip.x0, w.x1);
        clip.y1 = (int16_t)test_range(&seed, clip.y0, w.y1);
        test_canvas_open(&whole, w);
        etch_line_draw_dda(&whole.surface, p[0], p[1], p[2], p[3], TEST_INK);
        test_canvas_open(&canvas, w);
        test_canvas_clip(&canvas, clip);
        etch_line_draw_dda(&canvas.surface, p[0], p[1], p[2], p[3], TEST_INK);
        for (y = clip.y0; y < clip.y1; y++)
            for (x = clip.x0; x < clip.x1; x++)
                CHECK_EQ(test_canvas_drawn(&canvas, x, y), test_canvas_drawn(&whole, x, y));
    }
}

void suite_line_dda(void)
{
    RUN(error_is_stated);
    RUN(ends_are_drawn);
    RUN(exact_slopes_are_bresenhams);
    RUN(clips_only_mask);
}
