/* tests/unit: how the panel drivers send: windows, pieces, strides, and several panels at once. */
#include "panel_parts.h"

void suite_panel_send(void);

static struct etch_panel_port port;

static bool open_port(const char *name, uint8_t turn)
{
    return CHECK_EQ(etch_panel_port_open(&port, name, turn), 0);
}

/* A strip costs one transaction with one window; panels without a write command get one window a
 * frame, both sides of it the first time, and one side by turns while it stays the same. Pixels
 * are as many as the frame has. */
static void the_window_is_set_once_a_strip(void)
{
    for (const struct etch_panel_type *t = etch_panel_types; t->name != NULL; t++) {
        const bool one = t->family == ETCH_PANEL_SSD1306 || t->family == ETCH_PANEL_SSD0323;
        const int strips = (t->height + 15) / 16;
        int side = 0;

        if (!open_port(t->name, 0))
            return;
        for (int n = 1; n <= 3; n++) {
            etch_panel_count(&port.panel);
            CHECK_EQ(panel_frame(&port, n, 16, 2), 0);
            panel_check(&port, n);
            CHECK_EQ(port.panel.transactions, strips);
            CHECK_EQ(port.panel.commands, !one ? 3 * strips : n == 1 ? 2 : 1);
            CHECK_EQ(port.panel.pixels, (int32_t)t->width * t->height);
            CHECK(!one || n < 3 || port.panel.command != side);
            side = port.panel.command;
        }
        etch_panel_port_close(&port);
    }
}

/* Where one window serves frame after frame, an address counter that noise put out of step is back
 * in step after two frames. */
static void lost_steps_heal(void)
{
    static const char *const names[] = {"ssd1306", "ssd0323", "ssd1306-128x32"};

    for (int i = 0; i < 24; i++) {
        if (!open_port(names[i % 3], (uint8_t)(i / 6)))
            return;
        CHECK_EQ(panel_frame(&port, 1, 64, 1), 0);
        port.panel.x += i % 2 == 0;
        port.panel.y += i % 2 != 0;
        for (int n = 2; n <= 3; n++) {
            port.panel.error[0] = 0;
            CHECK_EQ(panel_frame(&port, n, 64, 1), 0);
            port.panel.error[0] = 0; /* bytes beyond the window wrap, as the data sheets say */
        }
        panel_check(&port, 3);
        etch_panel_port_close(&port);
    }
}

/* All of a strip's pieces go while the next strip is drawn: flush makes at most two and starts the
 * first, whether pixels are converted, lie apart, or are more than the bus takes at once. */
static void flush_returns_before_the_pixels_are_sent(void)
{
    static uint16_t pixels[64 * 64];
    const struct etch_display *d = &port.lcd.display;

    for (size_t i = 0; i < sizeof pixels / sizeof pixels[0]; i++)
        pixels[i] = (uint16_t)(i * 1009);
    for (const struct etch_panel_type *t = etch_panel_types; t->name != NULL; t++) {
        const bool mono = t->family == ETCH_PANEL_SSD1306;
        const int16_t height = t->height < 64 ? t->height : 64;
        uint32_t before;

        if (!open_port(t->name, 0))
            return;
        port.bus.bus.limit = 64;
        etch_panel_count(&port.panel);
        CHECK_EQ(d->flush(d, (struct etch_rect){8, 0, 56, height}, pixels, 64), 0);
        CHECK_EQ(port.panel.pixels, 0);
        CHECK(port.bus.left != 0 && port.bus.left <= 64);
        before = port.bus.pieces;
        CHECK_EQ(d->wait(d), 0);
        CHECK(port.panel.pixels == 48U * (uint32_t)height && port.panel.error[0] == 0);
        CHECK(port.bus.pieces - before >= (mono ? 2U : 23U)); /* started by interrupts */
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

/* ---- a bus that blocks, as ports/README.md writes it --------------------------------------------
 */

static struct etch_panel glass;

static int begin(const struct etch_bus *b)
{
    (void)b;
    etch_panel_select(&glass, true);
    return 0;
}
static void end(const struct etch_bus *b)
{
    (void)b;
    etch_panel_select(&glass, false);
}
static int command(const struct etch_bus *b, const uint8_t *bytes, uint16_t n)
{
    (void)b;
    for (; n > 0; n--)
        etch_panel_command(&glass, *bytes++);
    return 0;
}
static int data(const struct etch_bus *b, struct etch_pieces *pieces)
{
    const uint8_t *p;
    uint32_t n;

    (void)b;
    while ((p = pieces->next(pieces, &n)) != NULL)
        for (; n > 0; n--)
            etch_panel_data(&glass, *p++);
    return 0;
}
static int wait(const struct etch_bus *b)
{
    (void)b;
    return 0;
}
static void reset(const struct etch_bus *b, bool active)
{
    (void)b;
    etch_panel_reset(&glass, active);
}
static void delay(const struct etch_bus *b, uint8_t ms)
{
    (void)b;
    etch_panel_elapse(&glass, ms * UINT64_C(1000000));
}

/* Every panel on it. */
static void a_bus_may_block(void)
{
    static const struct etch_bus bus = {.begin = begin,
                                        .end = end,
                                        .command = command,
                                        .data = data,
                                        .wait = wait,
                                        .reset = reset,
                                        .delay = delay};

    for (const struct etch_panel_type *t = etch_panel_types; t->name != NULL; t++) {
        const struct etch_lcd_setup setup = {.scratch = port.scratch, .scratch_size = 12};

        if (!CHECK(etch_panel_open(&glass, t)))
            return;
        CHECK_EQ(etch_lcd_open(&port.lcd, etch_panel_driver(t->name), &bus, setup), 0);
        CHECK_EQ(panel_frame(&port, 6, 16, 2), 0);
        port.panel = glass;
        port.turn = 0;
        panel_check(&port, 6);
        etch_panel_close(&glass);
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

void suite_panel_send(void)
{
    RUN(the_window_is_set_once_a_strip);
    RUN(lost_steps_heal);
    RUN(flush_returns_before_the_pixels_are_sent);
    RUN(limits_are_kept);
    RUN(strides_are_kept);
    RUN(a_bus_may_block);
    RUN(two_panels_side_by_side);
}
