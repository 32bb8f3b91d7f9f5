/* tests/unit: ports/familiar's text and images: cells, wrapping, bounds and datum as Adafruit
 * GFX and TFT_eSPI have them, letters as the font draws them; bitmaps bit by bit; strips. */
#include "ports/familiar/gfx_text.h"

#include "core/draw/text.h"
#include "ports/familiar/gfx_images.h"
#include "ports/familiar/gfx_shapes.h"
#include "ports/familiar/gfx_smooth.h"
#include "familiar_parts.h"

void suite_familiar_text(void);

static struct test_canvas canvas;
static struct gfx g;
static int16_t cover[65];

static void open(struct etch_rect window, bool swapped)
{
    test_canvas_open(&canvas, window);
    gfx_begin(&g, 64, 48, swapped);
    g.surface = canvas.surface;
    oracle_gfx_open(canvas.surface.window, canvas.surface.clip, TEST_BACKGROUND);
}

/* Whether pixel (i, j) of a character's cell is ink: as draw/text.h draws it on row 7. */
static bool ink(char c, int i, int j)
{
    static uint16_t cell[8][8];
    const struct etch_text_style style = {&etch_font_fixed_5x8_ascii, etch_glyph_solid, 1, 0};
    const char text[2] = {c, '\0'};
    struct etch_surface s;

    CHECK_EQ(etch_surface_init(&s, cell[0], (struct etch_rect){0, 0, 8, 8}, 8), ETCH_OK);
    etch_surface_clear(&s, 0);
    (void)etch_text_draw(&s, &style, 0, GFX_BASELINE, text, NULL);
    return cell[j][i] != 0;
}

static void expect_cell(int32_t x, int32_t y, char c, int32_t sx, int32_t sy, uint16_t color,
                        uint16_t background)
{
    for (int j = 0; j < 8; j++)
        for (int i = 0; i < 6; i++)
            if (ink(c, i, j))
                oracle_gfx_fill_rect(x + i * sx, y + j * sy, sx, sy, color);
            else if (background != color)
                oracle_gfx_fill_rect(x + i * sx, y + j * sy, sx, sy, background);
}

static void text_fills_cells_of_6_by_8(void)
{
    static const char words[] = "Ag|\n3\rxyz\x80~";
    uint32_t seed = 1;

    for (int32_t i = 0; i < TEST_COUNT(200) && !test_failed(); i++) {
        const int size = 1 + i % 3;
        int32_t x = test_range(&seed, -20, 60), y = test_range(&seed, -20, 40);

        open((struct etch_rect){0, 0, 64, 48}, i % 2 == 1);
        gfx_setTextSize(&g, (uint8_t)size);
        gfx_setTextWrap(&g, i % 5 != 0);
        gfx_setCursor(&g, (int16_t)x, (int16_t)y);
        if (i % 4 < 2)
            gfx_setTextColor(&g, 0x1234);
        else
            gfx_setTextColorOn(&g, 0x1234, 0x0077);
        gfx_print(&g, words);
        for (const char *c = words; *c != '\0'; c++) {
            if (*c == '\r')
                continue;
            if (*c == '\n' || (i % 5 != 0 && x + 6 * size > 64)) {
                x = 0;
                y += 8 * size;
            }
            if (*c == '\n')
                continue;
            expect_cell(x, y, *c, size, size, gfx_stored(&g, 0x1234),
                        gfx_stored(&g, i % 4 < 2 ? 0x1234 : 0x0077));
            x += 6 * size;
        }
        CHECK(g.cursor_x == x && g.cursor_y == y);
        same_pixels(&canvas);
    }
}

static void numbers_are_printed_in_bases(void)
{
    static const struct {
        int32_t value;
        uint8_t base;
        const char *text;
    } cases[] = {{0, 10, "0"},     {-5, 10, "-5"},       {INT32_MIN, 10, "-2147483648"},
                 {255, 16, "FF"},  {-1, 16, "FFFFFFFF"}, {5, 2, "101"},
                 {35, 36, "Z"},    {7, 0, "7"},          {8, 8, "10"},
                 {-12, 200, "-12"}};

    for (unsigned k = 0; k < sizeof cases / sizeof cases[0]; k++) {
        static uint32_t hash[2];

        for (int way = 0; way < 2; way++) {
            open((struct etch_rect){0, 0, 64, 48}, false);
            if (way == 0)
                gfx_printNumber(&g, cases[k].value, cases[k].base);
            else
                gfx_print(&g, cases[k].text);
            hash[way] = test_canvas_hash(&canvas);
        }
        CHECK_EQ(hash[0], hash[1]);
    }
}

static void bounds_hold_the_cells(void)
{
    int16_t x1, y1;
    uint16_t w, h;

    open((struct etch_rect){0, 0, 64, 48}, false);
    gfx_getTextBounds(&g, "abc", 3, 5, &x1, &y1, &w, &h);
    CHECK(x1 == 3 && y1 == 5 && w == 18 && h == 8);
    gfx_setTextSize(&g, 2);
    gfx_getTextBounds(&g, "a\nbcd", 30, 5, &x1, &y1, &w, &h);
    CHECK(x1 == 0 && y1 == 5 && w == 42 && h == 32);
    gfx_getTextBounds(&g, "abcdef", 10, 0, &x1, &y1, &w, &h); /* 4 of 12 fit in 64 from 10 on */
    CHECK(x1 == 0 && y1 == 0 && w == 58 && h == 32);
    gfx_getTextBounds(&g, "\n\r", 9, 8, &x1, &y1, &w, &h);
    CHECK(x1 == 9 && y1 == 8 && w == 0 && h == 0);
}

static void strings_stand_about_their_datum(void)
{
    for (uint8_t datum = 0; datum < 9; datum++) {
        open((struct etch_rect){0, 0, 64, 48}, false);
        gfx_setTextDatum(&g, datum);
        gfx_setTextColor(&g, 5);
        CHECK_EQ(gfx_drawString(&g, "Hi!", 30, 24), 18);
        for (int k = 0; k < 3; k++)
            expect_cell(30 - 9 * (datum % 3) + 6 * k, 24 - 4 * (datum / 3), "Hi!"[k], 1, 1, 5, 5);
        same_pixels(&canvas);
    }
    CHECK(gfx_textWidth(&g, "Hi!") == 18 && gfx_fontHeight(&g) == 8);
}

static void bitmaps_are_bits(void)
{
    uint32_t seed = 7;
    uint8_t bits[5 * 40];

    for (unsigned k = 0; k < sizeof bits; k++)
        bits[k] = (uint8_t)test_random(&seed);
    for (int32_t i = 0; i < TEST_COUNT(400) && !test_failed(); i++) {
        const int w = (int)test_range(&seed, -2, 40), h = (int)test_range(&seed, 0, 40);
        const int x = (int)test_range(&seed, -30, 70), y = (int)test_range(&seed, -30, 50);
        const int kind = (int)(i % 3);

        open((struct etch_rect){0, 0, 64, 48}, i % 2 == 1);
        if (kind == 0)
            gfx_drawBitmap(&g, (int16_t)x, (int16_t)y, bits, (int16_t)w, (int16_t)h, 0x0123);
        else if (kind == 1)
            gfx_drawXBitmap(&g, (int16_t)x, (int16_t)y, bits, (int16_t)w, (int16_t)h, 0x0123);
        else
            gfx_drawBitmapOn(&g, (int16_t)x, (int16_t)y, bits, (int16_t)w, (int16_t)h, 0x0123, 9);
        for (int j = 0; j < h; j++)
            for (int k = 0; k < w; k++) {
                const uint8_t byte = bits[j * ((w + 7) / 8) + k / 8];
                const bool set = (kind == 1 ? byte >> k % 8 : byte << k % 8 >> 7 & 1) % 2 != 0;

                if (set || kind == 2)
                    oracle_gfx_pixel(x + k, y + j, gfx_stored(&g, set ? 0x0123 : 9));
            }
        same_pixels(&canvas);
    }
}

static void images_come_in_both_byte_orders(void)
{
    uint16_t data[7 * 5], plain[7 * 5];

    for (int i = 0; i < 7 * 5; i++) {
        const uint8_t high = (uint8_t)(i * 37), low = (uint8_t)(i / 3);
        uint8_t *const byte = (uint8_t *)&data[i];

        plain[i] = (uint16_t)(high << 8 | low);
        byte[0] = high; /* as a panel takes it */
        byte[1] = low;
    }
    for (int k = 0; k < 16; k++) {
        const bool key = (k & 4) != 0, numbers = (k & 2) != 0;
        const int x = (k & 8) != 0 ? 60 : -3, y = (k & 8) != 0 ? -2 : 46;

        open((struct etch_rect){0, 0, 64, 48}, (k & 1) != 0);
        gfx_setSwapBytes(&g, numbers);
        if (key)
            gfx_pushImageKey(&g, (int16_t)x, (int16_t)y, 7, 5, numbers ? plain : data, plain[9]);
        else if (numbers)
            gfx_drawRGBBitmap(&g, (int16_t)x, (int16_t)y, plain, 7, 5);
        else
            gfx_pushImage(&g, (int16_t)x, (int16_t)y, 7, 5, data);
        for (int i = 0; i < 7 * 5; i++)
            if (!key || i != 9)
                oracle_gfx_pixel(x + i % 7, y + i / 7, gfx_stored(&g, plain[i]));
        same_pixels(&canvas);
    }
}

/* Smooth circles are as wide as others; an arc from the bottom to the left is in that quarter. */
static void smooth_shapes_are_where_their_names_say(void)
{
    open((struct etch_rect){0, 0, 64, 48}, false);
    gfx_fillSmoothCircle(&g, 30, 24, 10, 0xFFFF, cover);
    CHECK(test_canvas_at(&canvas, 20, 24) == 0xFFFF && !test_canvas_drawn(&canvas, 19, 24));
    CHECK(test_canvas_at(&canvas, 30, 34) == 0xFFFF && !test_canvas_drawn(&canvas, 30, 35));
    open((struct etch_rect){0, 0, 64, 48}, false);
    gfx_drawSmoothCircle(&g, 30, 24, 10, 0xFFFF, cover);
    CHECK(test_canvas_drawn(&canvas, 20, 24) && test_canvas_drawn(&canvas, 40, 24));
    CHECK(!test_canvas_drawn(&canvas, 30, 24));
    for (int turn = 0; turn < 2; turn++) {
        open((struct etch_rect){0, 0, 64, 48}, false);
        gfx_drawArc(&g, 30, 24, 20, 16, turn == 0 ? 0 : 270, turn == 0 ? 90 : 360, 0xFFFF, cover);
        for (int y = 0; y < 48; y++)
            for (int x = 0; x < 64; x++)
                CHECK(!test_canvas_drawn(&canvas, x, y) ||
                      (y >= 24 && (turn == 0 ? x <= 30 : x >= 30)));
        CHECK_EQ(test_canvas_at(&canvas, turn == 0 ? 17 : 43, 37), 0xFFFF);
    }
    open((struct etch_rect){0, 0, 64, 48}, false);
    gfx_drawArc(&g, 30, 24, 20, 16, 300, 60, 0xFFFF, cover); /* over the bottom */
    CHECK(test_canvas_at(&canvas, 30, 42) == 0xFFFF && !test_canvas_drawn(&canvas, 30, 6));
    open((struct etch_rect){0, 0, 64, 48}, false);
    gfx_drawWideLine(&g, 10, 10, 40, 10, 5 * 256, 0xFFFF, cover);
    CHECK(test_canvas_at(&canvas, 25, 8) == 0xFFFF && test_canvas_at(&canvas, 25, 12) == 0xFFFF);
    CHECK(!test_canvas_drawn(&canvas, 25, 7) && !test_canvas_drawn(&canvas, 25, 13));
    open((struct etch_rect){0, 0, 64, 48}, false);
    gfx_fillSmoothRoundRect(&g, 5, 6, 20, 10, 3, 0xFFFF, cover);
    CHECK(test_canvas_at(&canvas, 5, 11) == 0xFFFF && test_canvas_at(&canvas, 24, 11) == 0xFFFF);
    CHECK(!test_canvas_drawn(&canvas, 4, 11) && !test_canvas_drawn(&canvas, 25, 11));
    CHECK(test_canvas_at(&canvas, 5, 6) != 0xFFFF);
}

static void draw_screen(struct gfx *to)
{
    gfx_fillScreen(to, 0x2104);
    gfx_fillRoundRect(to, 3, 4, 40, 30, 9, 0x4A69);
    gfx_fillTriangle(to, 60, 2, 20, 44, 50, 30, 0xF800);
    gfx_setCursor(to, 2, 12);
    gfx_setTextSize(to, 2);
    gfx_print(to, "etch 12");
    gfx_fillSmoothCircle(to, 50, 36, 9, 0x07E0, cover);
}

static void strips_are_the_whole(void)
{
    static struct test_canvas strip;

    open((struct etch_rect){0, 0, 64, 48}, true);
    draw_screen(&g);
    for (int16_t top = 0; top < 48; top = (int16_t)(top + 5)) {
        const int16_t end = (int16_t)(top + 5 < 48 ? top + 5 : 48);

        test_canvas_open(&strip, (struct etch_rect){0, top, 64, end});
        gfx_begin(&g, 64, 48, true);
        g.surface = strip.surface;
        draw_screen(&g);
        for (int16_t y = top; y < end; y++)
            for (int16_t x = 0; x < 64 && !test_failed(); x++)
                CHECK_EQ(test_canvas_at(&strip, x, y), test_canvas_at(&canvas, x, y));
        CHECK_INSIDE(&strip);
    }
}

void suite_familiar_text(void)
{
    RUN(text_fills_cells_of_6_by_8);
    RUN(numbers_are_printed_in_bases);
    RUN(bounds_hold_the_cells);
    RUN(strings_stand_about_their_datum);
    RUN(bitmaps_are_bits);
    RUN(images_come_in_both_byte_orders);
    RUN(smooth_shapes_are_where_their_names_say);
    RUN(strips_are_the_whole);
}
