/* tests/unit: the panel drivers, by what simulated panels show of the bytes they get. */
#include "panel_parts.h"

void suite_panel(void);

static struct etch_panel_port port;

static bool open_port(const char *name, uint8_t turn)
{
    return CHECK_EQ(etch_panel_port_open(&port, name, turn), 0);
}

static void frames_of(const struct etch_panel_type *type, uint8_t turn)
{
    for (int buffers = 1; buffers <= 2; buffers++) {
        if (!open_port(type->name, turn))
            return;
        CHECK_EQ(panel_frame(&port, 1, 16, buffers), 0);
        panel_check(&port, 1);
        CHECK_EQ(panel_frame(&port, 2, buffers == 1 ? 13 : port.lcd.display.height, buffers), 0);
        panel_check(&port, 2);
        etch_panel_port_close(&port);
        if (test_failed())
            return;
    }
}

/* Every panel in all rotations, with one and two buffers, in strips of 16 rows, of a height that
 * does not divide the frame, and whole: the viewer sees the picture as drawn directly. */
static void every_panel_shows_the_frame(void)
{
    int panels = 0;

    for (const struct etch_panel_type *t = etch_panel_types; t->name != NULL; t++, panels++)
        for (uint8_t turn = 0; turn < 4; turn++)
            frames_of(t, turn);
    test_print_count("", panels, " panels, 4 rotations, 1 and 2 buffers: the picture is seen");
}

/* The same mirrored, left and right, top and bottom, and both. */
static void every_panel_mirrors(void)
{
    for (const struct etch_panel_type *t = etch_panel_types; t->name != NULL; t++) {
        for (uint8_t turn = 4; turn < 16; turn++) {
            if (!open_port(t->name, turn))
                return;
            CHECK_EQ(panel_frame(&port, turn, 24, 2), 0);
            panel_check(&port, turn);
            etch_panel_port_close(&port);
        }
    }
}

/* Turned while it runs: without another start-up. */
static void a_panel_turns_while_it_runs(void)
{
    for (const struct etch_panel_type *t = etch_panel_types; t->name != NULL; t++) {
        if (!open_port(t->name, 3))
            return;
        for (uint8_t turn = 0; turn < 4; turn++) {
            CHECK_EQ(etch_lcd_turn(&port.lcd, turn), 0);
            port.turn = turn;
            CHECK_EQ(panel_frame(&port, turn, 16, 1), 0);
            panel_check(&port, turn);
        }
        etch_panel_port_close(&port);
    }
}

/* Start column and row in each rotation as module makers publish them. */
static void offsets_are_those_published(void)
{
    static const struct {
        const char *name;
        int16_t column[4], row[4];
    } known[] = {
        {"ili9341", {0, 0, 0, 0}, {0, 0, 0, 0}},
        {"st7789-240x240", {0, 0, 0, 80}, {0, 0, 80, 0}},
        {"st7789-135x240", {52, 40, 53, 40}, {40, 53, 40, 52}},
        {"st7735-red", {0, 0, 0, 0}, {0, 0, 0, 0}},
        {"st7735-green", {2, 1, 2, 1}, {1, 2, 1, 2}},
        {"st7735-128x128", {2, 3, 2, 1}, {3, 2, 1, 2}},
        {"st7735-80x160", {26, 1, 26, 1}, {1, 26, 1, 26}},
    };

    for (size_t i = 0; i < sizeof known / sizeof known[0]; i++) {
        if (!open_port(known[i].name, 0))
            return;
        for (uint8_t turn = 0; turn < 4; turn++) {
            CHECK_EQ(etch_lcd_turn(&port.lcd, turn), 0);
            CHECK_EQ(port.lcd.column, known[i].column[turn]);
            CHECK_EQ(port.lcd.row, known[i].row[turn]);
        }
        etch_panel_port_close(&port);
    }
}

/* Nobody sees the noise that the memory holds after power-up, nor does an opened panel show
 * anything but black. */
static void a_panel_opens_black(void)
{
    for (const struct etch_panel_type *t = etch_panel_types; t->name != NULL; t++) {
        if (!open_port(t->name, 0))
            return;
        for (int y = 0; y < t->height; y++)
            for (int x = 0; x < t->width; x++)
                CHECK_EQ(etch_panel_glass(&port.panel, x, y), 0);
        CHECK(port.panel.on && !port.panel.asleep && port.panel.error[0] == 0);
        etch_panel_port_close(&port);
    }
}

static uint32_t corner(void)
{
    return etch_panel_view(&port.panel, 0, port.lcd.display.width - 1, 0);
}

/* Off and asleep the glass is dark, inverted it is the complement, and all of it comes back. */
static void settings_work(void)
{
    for (const struct etch_panel_type *t = etch_panel_types; t->name != NULL; t++) {
        uint32_t seen;

        if (!open_port(t->name, 0))
            return;
        CHECK_EQ(panel_frame(&port, 0, 16, 1), 0);
        seen = corner();
        CHECK_EQ(etch_lcd_invert(&port.lcd, true), 0);
        CHECK_EQ(corner(), seen ^ 0xFFFFFF);
        CHECK_EQ(etch_lcd_sleep(&port.lcd, true), 0);
        CHECK(port.panel.asleep && corner() == 0);
        etch_panel_elapse(&port.panel, 120000000);
        CHECK_EQ(etch_lcd_sleep(&port.lcd, false), 0);
        CHECK_EQ(corner(), seen ^ 0xFFFFFF);
        CHECK_EQ(etch_lcd_invert(&port.lcd, false), 0);
        CHECK_EQ(etch_lcd_show(&port.lcd, false), 0);
        CHECK_EQ(corner(), 0);
        CHECK_EQ(etch_lcd_show(&port.lcd, true), 0);
        panel_check(&port, 0);
        CHECK_EQ(etch_lcd_brightness(&port.lcd, 200),
                 port.lcd.panel->controller->brightness != 0 ? 0 : ETCH_EINVAL);
        CHECK(port.panel.error[0] == 0);
        etch_panel_port_close(&port);
    }
}

/* A strip costs one transaction with one window; small panels without a write command get one
 * window a frame. Pixels are as many as the frame has. */
static void the_window_is_set_once_a_strip(void)
{
    for (const struct etch_panel_type *t = etch_panel_types; t->name != NULL; t++) {
        const bool one = t->family == ETCH_PANEL_SSD1306 || t->family == ETCH_PANEL_SSD0323;
        const int strips = (t->height + 15) / 16;

        if (!open_port(t->name, 0))
            return;
        etch_panel_count(&port.panel);
        CHECK_EQ(panel_frame(&port, 5, 16, 2), 0);
        CHECK_EQ(port.panel.transactions, strips);
        CHECK_EQ(port.panel.commands, one ? 2 : 3 * strips);
        CHECK_EQ(port.panel.pixels, (int32_t)t->width * t->height);
        etch_panel_port_close(&port);
    }
}

/* A bus that moves few bytes at once, and a small scratch buffer, change nothing. */
static void limits_are_kept(void)
{
    for (const struct etch_panel_type *t = etch_panel_types; t->name != NULL; t++) {
        if (!open_port(t->name, 1))
            return;
        port.bus.bus.limit = 101;
        port.lcd.setup.scratch_size = 13;
        CHECK_EQ(panel_frame(&port, 9, 16, 2), 0);
        panel_check(&port, 9);
        etch_panel_port_close(&port);
    }
}

/* A rectangle out of a wider buffer, row by row. */
static void strides_are_kept(void)
{
    static uint16_t pixels[40 * 64];
    const struct etch_rect area = {16, 8, 48, 40};

    for (size_t i = 0; i < sizeof pixels / sizeof pixels[0]; i++)
        pixels[i] = (uint16_t)(i * 977);
    for (const struct etch_panel_type *t = etch_panel_types; t->name != NULL; t++) {
        const struct etch_display *d = &port.lcd.display;

        if (t->height < 40 || !open_port(t->name, 0))
            continue;
        CHECK_EQ(d->flush(d, area, pixels, 40), 0);
        CHECK_EQ(d->wait(d), 0);
        for (int y = 0; y < t->height && !test_failed(); y++) {
            for (int x = 0; x < t->width; x++) {
                const bool in = x >= 16 && x < 48 && y >= 8 && y < 40;
                const uint16_t raw = in ? pixels[(y - 8) * 40 + x - 16] : 0;
                const uint16_t color = d->format == ETCH_FORMAT_RGB565_SWAPPED
                                           ? etch_rgb565_swap(raw)
                                           : raw;

                CHECK_EQ(etch_panel_view(&port.panel, 0, x, y),
                         in ? panel_expected(t, color, x, y) : 0);
            }
        }
        etch_panel_port_close(&port);
    }
}

/* A user's own table is what is sent: here one that leaves an ST7789 inverted the other way. */
static void an_init_table_may_be_replaced(void)
{
    static const uint8_t init[] = {ETCH_LCD_DELAY, 0x11, 120, 1, 0x3A, 0x55, ETCH_LCD_END};
    struct etch_lcd_panel own = etch_st7789;

    own.init = init;
    CHECK(etch_panel_open(&port.panel, etch_panel_find("st7789")));
    etch_panel_bus_open(&port.bus, &port.panel);
    port.turn = 0;
    CHECK_EQ(etch_lcd_open(&port.lcd, &own, &port.bus.bus, (struct etch_lcd_setup){0}), 0);
    CHECK_EQ(panel_frame(&port, 3, 16, 2), 0);
    panel_check(&port, 3);
    etch_panel_port_close(&port);
}

/* Panels that are not listed are one table each, as ports/README.md tells: a 1.47" glass on a known
 * controller, and an ST7796 of 320 x 480. All rotations follow. */
static void a_new_panel_is_one_table(void)
{
    static const uint8_t init[] = {ETCH_LCD_DELAY, 0x11, 120, 1, 0x3A, 0x55, ETCH_LCD_END};
    static const struct etch_panel_type types[] = {
        {"st7789-172x320", ETCH_PANEL_DCS, 172, 320, 240, 320, 34, 0, false, false, false, true,
         false},
        {"st7796", ETCH_PANEL_DCS, 320, 480, 320, 480, 0, 0, true, false, true, false, false}};
    struct etch_lcd_panel own[2] = {etch_st7789, etch_ili9341};

    own[0].width = 172;
    own[0].column = 34;
    own[1].init = init;
    own[1].width = own[1].memory_width = 320;
    own[1].height = own[1].memory_height = 480;
    for (int i = 0; i < 8; i++) {
        const struct etch_lcd_setup setup = {.turn = (uint8_t)(i / 2)};

        CHECK(etch_panel_open(&port.panel, &types[i % 2]));
        etch_panel_bus_open(&port.bus, &port.panel);
        port.turn = setup.turn;
        CHECK_EQ(etch_lcd_open(&port.lcd, &own[i % 2], &port.bus.bus, setup), 0);
        CHECK_EQ(panel_frame(&port, i, 16, 2), 0);
        panel_check(&port, i);
        etch_panel_port_close(&port);
    }
}

/* Two displays of different kinds at once, their frames interleaved strip by strip. */
static void two_panels_side_by_side(void)
{
    static struct etch_panel_port other;
    static uint16_t buffer[2][320 * 16];
    struct etch_frame frame[2];
    struct etch_surface *strip[2];
    struct etch_panel_port *const ports[2] = {&port, &other};

    if (!open_port("ili9341", 1) || !CHECK_EQ(etch_panel_port_open(&other, "ssd1306", 0), 0))
        return;
    for (int i = 0; i < 2; i++) {
        const struct etch_frame_memory m = {.pixels = {buffer[i]},
                                            .size = 16U * (uint32_t)ports[i]->lcd.display.width};

        CHECK_EQ(etch_frame_init(&frame[i], &ports[i]->lcd.display, m), 0);
        strip[i] = etch_frame_begin(&frame[i]);
    }
    while (strip[0] != NULL || strip[1] != NULL) {
        for (int i = 0; i < 2; i++) {
            if (strip[i] != NULL) {
                panel_picture(strip[i], ports[i]->lcd.display.format, 20 + i);
                strip[i] = etch_frame_next(&frame[i]);
            }
        }
    }
    for (int i = 0; i < 2; i++) {
        CHECK_EQ(etch_frame_end(&frame[i]), 0);
        panel_check(ports[i], 20 + i);
        etch_panel_port_close(ports[i]);
    }
}

/* Over each 8 x 8 block of one grey, the mean of the dithered levels is the grey to 1/64. */
static void dithering_keeps_the_mean(void)
{
    static const char *const names[] = {"ssd1306", "ssd0323"};

    for (int k = 0; k < 2; k++) {
        if (!open_port(names[k], 0))
            return;
        for (uint16_t level = 0; level < 64; level++) {
            const struct etch_display *d = &port.lcd.display;
            const uint16_t c = (uint16_t)((level / 2) << 11 | level << 5 | level / 2);
            const uint16_t pixel = d->format == ETCH_FORMAT_RGB565 ? c : etch_rgb565_swap(c);
            const uint32_t light = (77U * etch_rgb565_red(c) + 150U * etch_rgb565_green(c) +
                                    29U * etch_rgb565_blue(c)) /
                                   256;
            uint16_t block[64];
            uint32_t sum = 0;

            for (int i = 0; i < 64; i++)
                block[i] = pixel;
            CHECK_EQ(d->flush(d, (struct etch_rect){8, 8, 16, 16}, block, 8), 0);
            CHECK_EQ(d->wait(d), 0);
            for (int i = 0; i < 64; i++)
                sum += etch_panel_view(&port.panel, 0, 8 + i % 8, 8 + i / 8) & 0xFF;
            /* sum / 64 within 255 / (64 levels) of light, plus the rounding of light to q. */
            CHECK(sum <= light * 64 + 255U / (k == 0 ? 1 : 15) &&
                  light * 64 <= sum + 255U / (k == 0 ? 1 : 15));
        }
        etch_panel_port_close(&port);
    }
}

void suite_panel(void)
{
    RUN(every_panel_shows_the_frame);
    RUN(every_panel_mirrors);
    RUN(a_panel_turns_while_it_runs);
    RUN(offsets_are_those_published);
    RUN(a_panel_opens_black);
    RUN(settings_work);
    RUN(the_window_is_set_once_a_strip);
    RUN(limits_are_kept);
    RUN(strides_are_kept);
    RUN(an_init_table_may_be_replaced);
    RUN(a_new_panel_is_one_table);
    RUN(two_panels_side_by_side);
    RUN(dithering_keeps_the_mean);
}
