/* tests/unit: ports/familiar draws what Adafruit GFX and TFT_eSPI say, pixel for pixel: shapes
 * against tests/oracle/gfx.h, whole and clipped, in both byte orders. */
#include "ports/familiar/gfx_shapes.h"

#include "familiar_parts.h"

void suite_familiar(void);

static struct test_canvas canvas;
static struct gfx g;

/* A window, and every other time a clip and the other byte order. */
static void open(int32_t i, uint32_t *seed)
{
    static const struct etch_rect windows[] = {
        {0, 0, 64, 48}, {100, 7, 160, 50}, {32710, 32731, 32767, 32767}};
    const struct etch_rect w = windows[i % 3];
    const struct etch_rect clip = {
        (int16_t)(w.x0 + test_range(seed, 0, 30)), (int16_t)(w.y0 + test_range(seed, 0, 20)),
        (int16_t)(w.x1 - test_range(seed, 0, 30)), (int16_t)(w.y1 - test_range(seed, 0, 20))};

    test_canvas_open(&canvas, w);
    if (i % 2 == 1)
        test_canvas_clip(&canvas, clip);
    gfx_begin(&g, 240, 320, i % 4 >= 2);
    g.surface = canvas.surface;
    oracle_gfx_open(canvas.surface.window, canvas.surface.clip, TEST_BACKGROUND);
}

/* A colour, and the same as memory has it. */
enum {
    COLOR = 0x12AB
};
static uint16_t stored(void)
{
    return g.swapped ? 0xAB12 : COLOR;
}

/* Near the window, and every eighth time anywhere within +-`far`. */
static int16_t some(int32_t i, uint32_t *seed, int32_t near, int32_t far)
{
    const int32_t v = i % 8 == 0 ? test_range(seed, -far, far) : near + test_range(seed, -40, 100);

    return (int16_t)(v > INT16_MAX ? INT16_MAX : v);
}

static void lines_have_both_ends(void)
{
    uint32_t seed = 1;

    for (int32_t i = 0; i < TEST_COUNT(3000) && !test_failed(); i++) {
        open(i, &seed);
        const int16_t ox = canvas.surface.window.x0, oy = canvas.surface.window.y0;
        const int16_t x0 = some(i, &seed, ox, 32767), y0 = some(i / 8, &seed, oy, 32767);
        const int16_t x1 = some(i, &seed, ox, 32767), y1 = some(i / 8, &seed, oy, 32767);

        gfx_drawLine(&g, x0, y0, x1, y1, COLOR);
        oracle_gfx_line(x0, y0, x1, y1, stored());
        if (!same_pixels(&canvas))
            test_note("x0", x0), test_note("y0", y0), test_note("x1", x1), test_note("y1", y1);
    }
}

static void rectangles_are_what_their_sides_say(void)
{
    uint32_t seed = 2;

    for (int32_t i = 0; i < TEST_COUNT(2000) && !test_failed(); i++) {
        open(i, &seed);
        const int16_t x = some(i, &seed, canvas.surface.window.x0, 32767);
        const int16_t y = some(i / 8, &seed, canvas.surface.window.y0, 32767);
        const int16_t w = some(i, &seed, 0, 32767), h = some(i / 8, &seed, 0, 32767);

        gfx_fillRect(&g, x, y, w, h, COLOR);
        oracle_gfx_fill_rect(x, y, w, h, stored());
        gfx_drawRect(&g, y, x, h, w, 7);
        if (w > 0 && h > 0) {
            oracle_gfx_fill_rect(y, x, h, 1, gfx_stored(&g, 7));
            oracle_gfx_fill_rect(y, x + w - 1, h, 1, gfx_stored(&g, 7));
            oracle_gfx_fill_rect(y, x, 1, w, gfx_stored(&g, 7));
            oracle_gfx_fill_rect(y + h - 1, x, 1, w, gfx_stored(&g, 7));
        }
        gfx_drawFastHLine(&g, x, (int16_t)(y / 2), w, 9);
        oracle_gfx_fill_rect(x, y / 2, w, 1, gfx_stored(&g, 9));
        gfx_drawFastVLine(&g, (int16_t)(x / 2), y, h, 11);
        oracle_gfx_fill_rect(x / 2, y, 1, h, gfx_stored(&g, 11));
        same_pixels(&canvas);
    }
}

/* Every radius up to 90, then any up to 2000. */
static void circles_are_midpoint_circles(void)
{
    uint32_t seed = 3;

    for (int32_t i = 0; i < TEST_COUNT(1500) && !test_failed(); i++) {
        open(i, &seed);
        const int16_t r = (int16_t)(i <= 90 ? i : test_range(&seed, 0, i % 9 == 0 ? 2000 : 60));
        const int16_t x = some(1, &seed, canvas.surface.window.x0 + (i % 9 == 0 ? r : 0), 0);
        const int16_t y = some(1, &seed, canvas.surface.window.y0, 0);

        gfx_fillCircle(&g, x, y, r, 5);
        gfx_drawCircle(&g, (int16_t)(x - 1), y, r, COLOR);
        oracle_gfx_disc(x, y, r, gfx_stored(&g, 5));
        oracle_gfx_circle(x - 1, y, r, stored());
        if (!same_pixels(&canvas))
            test_note("x", x), test_note("y", y), test_note("r", r);
    }
}

static void rounded_rectangles_have_quarters_of_circles(void)
{
    uint32_t seed = 4;

    for (int32_t i = 0; i < TEST_COUNT(3000) && !test_failed(); i++) {
        open(i, &seed);
        const int16_t x = some(i, &seed, canvas.surface.window.x0, 32767);
        const int16_t y = some(i, &seed, canvas.surface.window.y0, 32767);
        const int16_t w = some(1, &seed, 0, 0), h = some(1, &seed, 0, 0);
        const int16_t r = (int16_t)test_range(&seed, -3, 50);

        gfx_fillRoundRect(&g, x, y, w, h, r, 3);
        gfx_drawRoundRect(&g, (int16_t)(x / 2), y, h, w, r, COLOR);
        oracle_gfx_fill_round_rect(x, y, w, h, r, gfx_stored(&g, 3));
        oracle_gfx_round_rect(x / 2, y, h, w, r, stored());
        if (!same_pixels(&canvas))
            test_note("w", w), test_note("h", h), test_note("r", r);
    }
}

static void triangles_have_their_edges(void)
{
    uint32_t seed = 5;

    for (int32_t i = 0; i < TEST_COUNT(5000) && !test_failed(); i++) {
        open(i, &seed);
        const int16_t ox = canvas.surface.window.x0, oy = canvas.surface.window.y0;
        int16_t v[6];

        for (int k = 0; k < 6; k++)
            v[k] = some(i + k, &seed, k % 2 == 0 ? ox : oy, 32767);
        if (i % 5 == 0)
            v[3] = v[1];
        if (i % 11 == 0)
            v[5] = v[3];
        gfx_fillTriangle(&g, v[0], v[1], v[2], v[3], v[4], v[5], COLOR);
        oracle_gfx_fill_triangle(v[0], v[1], v[2], v[3], v[4], v[5], stored());
        if (i % 2 == 0) {
            gfx_drawTriangle(&g, v[0], v[1], v[2], v[3], v[4], v[5], 6);
            for (int k = 0; k < 6; k += 2)
                oracle_gfx_line(v[k], v[k + 1], v[(k + 2) % 6], v[(k + 3) % 6], gfx_stored(&g, 6));
        }
        if (!same_pixels(&canvas))
            for (int k = 0; k < 6; k++)
                test_note("corner", v[k]);
    }
}

static void ellipses_reach_their_radii(void)
{
    open(0, &(uint32_t){1});
    gfx_drawEllipse(&g, 20, 20, 12, 5, COLOR);
    CHECK(test_canvas_drawn(&canvas, 8, 20) && !test_canvas_drawn(&canvas, 7, 20));
    CHECK(test_canvas_drawn(&canvas, 20, 25) && !test_canvas_drawn(&canvas, 20, 26));
    CHECK(!test_canvas_drawn(&canvas, 20, 20));
    gfx_fillEllipse(&g, 20, 20, 12, 5, COLOR);
    CHECK(test_canvas_drawn(&canvas, 20, 20) && test_canvas_drawn(&canvas, 32, 20));
    CHECK(!test_canvas_drawn(&canvas, 33, 20) && !test_canvas_drawn(&canvas, 32, 25));
}

static void colors_lose_their_low_bits(void)
{
    CHECK_EQ(gfx_color565(255, 255, 255), 0xFFFF);
    CHECK_EQ(gfx_color565(0x87, 0x43, 0x0F), 0x8201);
    for (int v = 0; v < 256; v++)
        CHECK_EQ(gfx_color565((uint8_t)v, (uint8_t)v, (uint8_t)v),
                 v / 8 * 2048 + v / 4 * 32 + v / 8);
}

static int turns;
static void count_turn(struct gfx *turned)
{
    turns += turned->rotation;
}

static void rotation_exchanges_sides(void)
{
    gfx_begin(&g, 240, 320, false);
    CHECK_EQ(gfx_width(&g), 240);
    gfx_setRotation(&g, 5);
    CHECK_EQ(gfx_getRotation(&g), 1);
    CHECK(gfx_width(&g) == 320 && gfx_height(&g) == 240);
    turns = 0;
    g.turn = count_turn;
    gfx_setRotation(&g, 2);
    CHECK(gfx_width(&g) == 240 && gfx_height(&g) == 320 && turns == 2);
}

static void pixels_are_read_as_they_were_drawn(void)
{
    for (int swapped = 0; swapped < 2; swapped++) {
        open(2 * swapped, &(uint32_t){1});
        gfx_fillScreen(&g, 0x1234);
        gfx_drawPixel(&g, canvas.surface.window.x0, canvas.surface.window.y0, COLOR);
        CHECK_EQ(gfx_readPixel(&g, canvas.surface.window.x0, canvas.surface.window.y0), COLOR);
        CHECK_EQ(
            gfx_readPixel(&g, (int16_t)(canvas.surface.window.x0 + 1), canvas.surface.window.y0),
            0x1234);
        CHECK_EQ(gfx_readPixel(&g, -1, 0), 0);
        CHECK_EQ(gfx_readPixel(&g, canvas.surface.window.x1, canvas.surface.window.y0), 0);
        CHECK_INSIDE(&canvas);
    }
}

void suite_familiar(void)
{
    RUN(lines_have_both_ends);
    RUN(rectangles_are_what_their_sides_say);
    RUN(circles_are_midpoint_circles);
    RUN(rounded_rectangles_have_quarters_of_circles);
    RUN(triangles_have_their_edges);
    RUN(ellipses_reach_their_radii);
    RUN(colors_lose_their_low_bits);
    RUN(rotation_exchanges_sides);
    RUN(pixels_are_read_as_they_were_drawn);
}
