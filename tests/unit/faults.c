/* tests/unit: faults of the bus through the frame loop. Whatever fails, at whatever call, the
 * frame that failed says so, nothing is lost silently, and the next frame is whole. */
#include "panel_parts.h"

void suite_faults(void);

static struct etch_panel_port port;

static const enum etch_panel_fault faults[] = {
    ETCH_PANEL_BEGIN_FAILS, ETCH_PANEL_COMMAND_FAILS, ETCH_PANEL_START_FAILS, ETCH_PANEL_FAILS,
    ETCH_PANEL_STALLS,      ETCH_PANEL_EARLY,         ETCH_PANEL_LATE,        ETCH_PANEL_TWICE};

static const char *const names[] = {"st7789-135x240", "ili9488", "ssd1306", "ssd0323"};

/* The status that the loop must report. */
static int status_of(enum etch_panel_fault fault)
{
    switch (fault) {
    case ETCH_PANEL_STALLS:
    case ETCH_PANEL_LATE:
    case ETCH_PANEL_EARLY: return ETCH_EIO;
    case ETCH_PANEL_TWICE: return 0;
    default: return ETCH_PANEL_FAULT_STATUS;
    }
}

/* One frame with the fault at its k-th call, and one without. Whether the frame had so many. */
static bool strike(enum etch_panel_fault fault, uint32_t k, int rows, int buffers)
{
    int status;
    bool struck;

    port.bus.fault = fault;
    port.bus.fault_at = k;
    status = panel_frame(&port, (int)k, rows, buffers);
    struck = port.bus.fault_at == 0;
    port.bus.fault_at = 0;
    CHECK_EQ(status, struck ? status_of(fault) : 0);
    CHECK(!port.bus.taken && !etch_transfer_runs(&port.bus.transfer));
    if (status == 0)
        panel_check(&port, (int)k);
    CHECK_EQ(panel_frame(&port, (int)k + 1, rows, buffers), 0);
    panel_check(&port, (int)k + 1);
    return struck;
}

/* Every fault at every call of a frame (of the first ten, and then of some), one and two
 * buffers. */
static void every_fault_is_reported(void)
{
    int32_t frames = 0;

    for (size_t n = 0; n < sizeof names / sizeof names[0]; n++) {
        if (!CHECK_EQ(etch_panel_port_open(&port, names[n], (uint8_t)(n & 3)), 0))
            return;
        for (size_t f = 0; f < sizeof faults / sizeof faults[0] && !test_failed(); f++) {
            for (int buffers = 1; buffers <= 2; buffers++) {
                uint32_t k = 1;

                while (strike(faults[f], k, 64, buffers) && !test_failed() && frames++ >= 0)
                    k += k < 10 ? 1 : k / 2 + 1;
            }
        }
        etch_panel_port_close(&port);
    }
    test_print_count("", frames, " frames with a fault: each reported, the next whole");
}

static int fails_now;

static int flush_well(const struct etch_display *display, struct etch_rect area,
                      const uint16_t *pixels, uint16_t stride)
{
    (void)display, (void)area, (void)pixels, (void)stride;
    return 0;
}

static int wait_or_fail(const struct etch_display *display)
{
    const int status = fails_now;

    (void)display;
    fails_now = 0;
    return status;
}

/* The last strip fails and the application begins again without having ended: it is told. */
static void a_frame_that_was_not_ended_is_not_lost(void)
{
    static uint16_t strip[8 * 4];
    static const struct etch_display display = {
        .width = 8, .height = 4, .flush = flush_well, .wait = wait_or_fail};
    struct etch_frame frame;

    CHECK_EQ(etch_frame_init(&frame, &display,
                             (struct etch_frame_memory){.pixels = {strip}, .size = 8 * 4}),
             0);
    CHECK(etch_frame_begin(&frame) != NULL);
    fails_now = -5;
    CHECK(etch_frame_next(&frame) == NULL);
    CHECK(etch_frame_begin(&frame) == NULL);
    CHECK(etch_frame_begin(&frame) == NULL);
    CHECK_EQ(etch_frame_end(&frame), -5);
    CHECK(etch_frame_begin(&frame) != NULL);
    CHECK(etch_frame_next(&frame) == NULL);
    CHECK_EQ(etch_frame_end(&frame), 0);
}

/* A completion that comes late or twice is seen, and ends nothing. */
static void stray_interrupts_come_and_do_nothing(void)
{
    if (!CHECK_EQ(etch_panel_port_open(&port, "ili9341", 0), 0))
        return;
    CHECK(strike(ETCH_PANEL_TWICE, 3, 16, 2));
    CHECK_EQ(port.bus.ignored, 1);
    CHECK(strike(ETCH_PANEL_LATE, 9, 16, 2));
    CHECK_EQ(port.bus.ignored, 2);
    etch_panel_port_close(&port);
}

/* The bus sees a buffer that is drawn on while it is sent: a loop that does not wait is caught. */
static void early_reuse_is_caught(void)
{
    static uint16_t pixels[240 * 4];
    const struct etch_display *d = &port.lcd.display;

    if (!CHECK_EQ(etch_panel_port_open(&port, "ili9341", 0), 0))
        return;
    CHECK_EQ(d->flush(d, (struct etch_rect){0, 0, 240, 4}, pixels, 240), 0);
    pixels[77] = 1;
    CHECK_EQ(d->wait(d), 0);
    CHECK(port.panel.error[0] != 0);
    etch_panel_port_close(&port);
}

/* A panel that gets one window a frame: after a strip that failed, the one below it lands where
 * it belongs. */
static void a_failed_strip_does_not_shift_the_next(void)
{
    static uint16_t white[128 * 32];
    const struct etch_display *d = &port.lcd.display;

    for (size_t i = 0; i < sizeof white / sizeof white[0]; i++)
        white[i] = 0xFFFF;
    if (!CHECK_EQ(etch_panel_port_open(&port, "ssd1306", 0), 0))
        return;
    for (int16_t y = 0; y < 64; y = (int16_t)(y + 16)) {
        port.bus.fault = ETCH_PANEL_FAILS;
        port.bus.fault_at = y == 16;
        CHECK_EQ(d->flush(d, (struct etch_rect){0, y, 128, (int16_t)(y + 16)}, white, 128), 0);
        CHECK_EQ(d->wait(d), y == 16 ? ETCH_PANEL_FAULT_STATUS : 0);
    }
    for (int y = 0; y < 64; y++)
        for (int x = 0; x < 128; x++)
            CHECK_EQ(etch_panel_view(&port.panel, 0, x, y) != 0,
                     y < 16 || y >= 32 || (y < 24 && x < 32));
    etch_panel_port_close(&port);
}

/* Opening reports what fails, leaves the bus, and succeeds the next time. */
static void opening_reports_faults(void)
{
    const struct etch_lcd_setup setup = {.scratch = port.scratch,
                                         .scratch_size = sizeof port.scratch};

    for (size_t f = 0; f < sizeof faults / sizeof faults[0]; f++) {
        for (uint32_t k = 1; k < 60; k += 7) {
            bool struck;
            int status;

            if (!CHECK_EQ(etch_panel_port_open(&port, "ili9341", 0), 0))
                return;
            port.bus.fault = faults[f];
            port.bus.fault_at = k;
            status = etch_lcd_open(&port.lcd, &etch_ili9341, &port.bus.bus, setup);
            struck = port.bus.fault_at == 0;
            port.bus.fault_at = 0;
            CHECK_EQ(status, struck ? status_of(faults[f]) : 0);
            CHECK(!port.bus.taken);
            CHECK_EQ(etch_lcd_open(&port.lcd, &etch_ili9341, &port.bus.bus, setup), 0);
            CHECK_EQ(panel_frame(&port, 1, 64, 2), 0);
            panel_check(&port, 1);
            etch_panel_port_close(&port);
        }
    }
}

void suite_faults(void)
{
    RUN(every_fault_is_reported);
    RUN(a_frame_that_was_not_ended_is_not_lost);
    RUN(stray_interrupts_come_and_do_nothing);
    RUN(early_reuse_is_caught);
    RUN(a_failed_strip_does_not_shift_the_next);
    RUN(opening_reports_faults);
}
