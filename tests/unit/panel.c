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

/* The orientation command in each rotation, the order of the colours included, as Adafruit's
 * drivers and TFT_eSPI send it. */
static void orientations_are_those_published(void)
{
    static const struct {
        const char *name;
        uint8_t value[4];
    } known[] = {
        {"ili9341", {0x48, 0x28, 0x88, 0xE8}},        {"ili9488", {0x48, 0x28, 0x88, 0xE8}},
        {"st7789", {0x00, 0x60, 0xC0, 0xA0}},         {"st7789-240x240", {0x00, 0x60, 0xC0, 0xA0}},
        {"st7789-135x240", {0x00, 0x60, 0xC0, 0xA0}}, {"st7735-black", {0xC0, 0xA0, 0x00, 0x60}},
        {"st7735-red", {0xC8, 0xA8, 0x08, 0x68}},     {"st7735-green", {0xC8, 0xA8, 0x08, 0x68}},
        {"st7735-128x128", {0xC8, 0xA8, 0x08, 0x68}}, {"st7735-80x160", {0xC8, 0xA8, 0x08, 0x68}},
        {"gc9a01", {0x08, 0x68, 0xC8, 0xA8}},         {"ssd1351", {0x74, 0x77, 0x66, 0x65}},
    };

    for (size_t i = 0; i < sizeof known / sizeof known[0]; i++) {
        for (uint8_t turn = 0; turn < 4; turn++) {
            if (!open_port(known[i].name, turn))
                return;
            if (!CHECK_EQ(port.panel.orient, known[i].value[turn]))
                test_print(known[i].name);
            etch_panel_port_close(&port);
        }
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
    RUN(orientations_are_those_published);
    RUN(a_panel_opens_black);
    RUN(dithering_keeps_the_mean);
}
