/* tests/unit: the small shapes and glyphs are the fast ones, pixel for pixel. */
#include "core/draw/shapes_small.h"

#include "core/draw/shapes.h"
#include "core/draw/text_small.h"
#include "core/fonts/fonts.h"
#include "core/raster/circle.h"
#include "tests/harness/canvas.h"

void suite_shapes_small(void);

static struct test_canvas fast, small;

/* A window and a clip for both. */
static void open(int32_t i, uint32_t *seed)
{
    static const struct etch_rect windows[] = {
        {0, 0, 64, 48}, {100, 7, 160, 50}, {32710, 32731, 32767, 32767}};
    const struct etch_rect w = windows[i % 3];
    const struct etch_rect clip = {
        (int16_t)(w.x0 + test_range(seed, 0, 30)), (int16_t)(w.y0 + test_range(seed, 0, 20)),
        (int16_t)(w.x1 - test_range(seed, 0, 30)), (int16_t)(w.y1 - test_range(seed, 0, 20))};

    test_canvas_open(&fast, w);
    if (i % 2 == 1)
        test_canvas_clip(&fast, clip);
    test_canvas_open(&small, w); /* last: its stores are counted */
    if (i % 2 == 1)
        test_canvas_clip(&small, clip);
}

static bool same(void)
{
    CHECK_ONCE(&small);
    return CHECK_EQ(test_canvas_hash(&small), test_canvas_hash(&fast));
}

static int16_t some(int32_t i, uint32_t *seed, int32_t near)
{
    const int32_t v = i % 4 == 0 ? test_range(seed, INT16_MIN, INT16_MAX)
                                 : near + test_range(seed, -40, 70);

    return (int16_t)(v > INT16_MAX ? INT16_MAX : v);
}

static void rectangles_are_those_of_rect_fill(void)
{
    uint32_t seed = 1;

    for (int32_t i = 0; i < TEST_COUNT(2000) && !test_failed(); i++) {
        open(i, &seed);
        const int16_t x = some(i, &seed, small.surface.window.x0), w = some(i / 4, &seed, 0);
        const int16_t y = some(i, &seed, small.surface.window.y0), h = some(i / 4, &seed, 0);

        etch_rect_fill(&fast.surface, x, y, w, h, 7);
        etch_rect_fill_small(&small.surface, x, y, w, h, 7);
        if (!same())
            test_note("x", x), test_note("y", y), test_note("w", w), test_note("h", h);
    }
}

static void compare_circle(int16_t x, int16_t y, int16_t r)
{
    etch_circle_draw(&fast.surface, x, y, r, 7);
    etch_circle_draw_small(&small.surface, x, y, r, 7);
    if (!same())
        test_note("x", x), test_note("y", y), test_note("r", r);
    test_canvas_wipe(&fast);
    test_canvas_wipe(&small);
    etch_circle_fill(&fast.surface, x, y, r, 7);
    etch_circle_fill_small(&small.surface, x, y, r, 7);
    if (!same())
        test_note("x", x), test_note("y", y), test_note("r of the disc", r);
}

/* A piece about the diagonal, the top and the side of each radius. */
static void circles_are_those_of_circle_draw(void)
{
    uint32_t seed = 2;

    for (int32_t r = -2; r < 700 && !test_failed(); r += r < 24 ? 1 : TEST_DIVISOR) {
        const int32_t out[3][2] = {{0, r}, {r * 46341 / 65536, r * 46341 / 65536}, {r, 0}};

        for (int32_t k = 0; k < 3; k++) {
            open(0, &seed);
            compare_circle((int16_t)(32 + (k & 1 ? out[k][0] : -out[k][0])),
                           (int16_t)(24 - out[k][1]), (int16_t)r);
        }
    }
    for (int32_t i = 0; i < TEST_COUNT(2000) && !test_failed(); i++) {
        open(i, &seed);
        const int32_t r = i % 5 == 0 ? test_range(&seed, 30000, 32767)
                                     : test_range(&seed, -1, 3000);
        const int32_t x = small.surface.window.x0 + test_range(&seed, 0, 60);
        const int32_t y = small.surface.window.y0 + test_range(&seed, 0, 40);
        const int32_t t = test_range(&seed, 0, r > 0 ? r : 0); /* the window is near the outline */
        const int32_t across = i % 2 == 0 ? t : r - t * t / (2 * r + 1);
        const int32_t cx = x + (i % 3 == 0 ? across : -across);

        compare_circle((int16_t)(cx > INT16_MAX   ? INT16_MAX
                                 : cx < INT16_MIN ? INT16_MIN
                                                  : cx),
                       (int16_t)(y - (r - across) > INT16_MIN ? y - (r - across) : INT16_MIN),
                       (int16_t)r);
    }
}

static void glyphs_are_those_of_solid(void)
{
    static const struct etch_font *const fonts[] = {&etch_font_fixed_5x8, &etch_font_fixed_9x15,
                                                    &etch_font_fixed_10x20};
    uint32_t seed = 3;

    for (int32_t i = 0; i < TEST_COUNT(600) && !test_failed(); i++) {
        open(i, &seed);
        const int16_t x = some(1, &seed, small.surface.window.x0);
        const int16_t y = some(1, &seed, small.surface.window.y0);
        const struct etch_text_style a = {fonts[i % 3], etch_glyph_solid, 7, 0};
        const struct etch_text_style b = {fonts[i % 3], etch_glyph_solid_small, 7, 0};

        etch_text_draw(&fast.surface, &a, x, y, "etch: \xC3\xA9 @W.,", NULL);
        etch_text_draw(&small.surface, &b, x, y, "etch: \xC3\xA9 @W.,", NULL);
        if (!same())
            test_note("x", x), test_note("y", y);
    }
}

void suite_shapes_small(void)
{
    RUN(rectangles_are_those_of_rect_fill);
    RUN(circles_are_those_of_circle_draw);
    RUN(glyphs_are_those_of_solid);
}
