/* tests/unit: when to begin a frame (hal/scan.h), against every line and every start tried one by
 * one, and by what a panel shows that is written at that time. */
#include "hal/scan.h"
#include "panel_parts.h"
#include "ports/host/panel_scan.h"

void suite_panel_scan(void);

/* True if no pass shows both: each line is written, by its own time and up to `jitter` later,
 * entirely before or entirely after the pass that is about to read it, the same for all lines.
 * In exact fractions of a microsecond, 1 / unit. */
static bool is_safe(const struct etch_scan *s, int64_t write, int64_t jitter, int64_t delay)
{
    const int64_t n = s->lines, all = n + s->blank, unit = n * all;
    bool ahead = true, behind = true;

    for (int64_t y = 0; y < n; y++) {
        const int64_t read = n * s->period_us * (s->blank + y), read_end = read + n * s->period_us;
        const int64_t from = delay * unit + write * all * y;
        const int64_t to = delay * unit + write * all * (y + 1) + jitter * unit;
        const int64_t next = read + unit * s->period_us;

        if (!s->along) { /* any line may be read first: all within the rest */
            if (to > n * s->period_us * s->blank)
                return false;
            continue;
        }
        ahead = ahead && to <= read;
        behind = behind && from >= read_end && to <= next;
    }
    return !s->along || ahead || behind;
}

/* The plan is safe, and "no" means that no whole microsecond is. */
static void plans_are_safe_and_found_if_there_are_any(void)
{
    uint32_t seed = 0x5CA4;
    int32_t plans = 0, refusals = 0;

    for (int32_t n = 0; n < TEST_COUNT(6000) && !test_failed(); n++) {
        const struct etch_scan s = {.period_us = (uint32_t)test_range(&seed, 1, 300),
                                    .lines = (uint16_t)test_range(&seed, 1, 40),
                                    .blank = (uint16_t)test_range(&seed, 0, 12),
                                    .along = test_range(&seed, 0, 4) != 0};
        const uint32_t write = (uint32_t)test_range(&seed, 0, 700);
        const uint32_t jitter = (uint32_t)test_range(&seed, 0, 3) * (uint32_t)(n % 7);
        const int32_t delay = etch_scan_plan(&s, write, jitter);

        if (delay >= 0) {
            plans++;
            CHECK(delay <= (int32_t)(2 * s.period_us));
            CHECK(is_safe(&s, write, jitter, delay));
            continue;
        }
        refusals++;
        CHECK_EQ(delay, ETCH_ERANGE);
        for (int32_t d = 0; d <= (int32_t)(2 * s.period_us); d++)
            CHECK(!is_safe(&s, write, jitter, d));
    }
    CHECK(plans > refusals / 4 && refusals > plans / 4);
    test_print_count("", plans, " plans hold, line by line");
    test_print_count("", refusals, " refusals, for which no start is safe");
}

static struct etch_panel_port port;

static struct etch_panel_scan scan_of(const struct etch_scan *s, bool up)
{
    const struct etch_panel_scan scan = {.period_ns = s->period_us * UINT64_C(1000),
                                         .first = port.panel.type->row,
                                         .lines = s->lines,
                                         .blank = s->blank,
                                         .up = up};
    return scan;
}

/* Passes torn by a whole frame that is begun delay_us after the pulse. */
static int torn_at(const struct etch_panel_scan *scan, int64_t delay_us, int number)
{
    etch_panel_elapse(&port.panel, etch_panel_until_pulse(&port.panel, scan));
    etch_panel_elapse(&port.panel, (uint64_t)delay_us * 1000);
    etch_panel_begin_changes(&port.panel);
    CHECK_EQ(panel_frame(&port, number, port.lcd.display.height, 1), 0);
    return etch_panel_torn(&port.panel, scan);
}

static const struct etch_scan square = {
    .period_us = 16667, .lines = 240, .blank = 12, .along = true};

/* On a panel at several bus clocks: begun as planned, no pass is torn; begun a millisecond too
 * late or too early, one is; where there is no plan, every start tears. */
static void a_frame_begun_as_planned_does_not_tear(void)
{
    static const uint32_t clocks[] = {80000000, 62500000, 40000000, 32000000, 20000000};
    int number = 1, planned = 0;

    if (!CHECK_EQ(etch_panel_port_open(&port, "st7789-240x240", 0), 0))
        return;
    for (size_t i = 0; i < sizeof clocks / sizeof clocks[0]; i++) {
        const struct etch_panel_scan scan = scan_of(&square, false);
        const uint32_t write = (uint32_t)(UINT64_C(8000000) * (240 * 240 * 2 + 11) / clocks[i]);
        const int32_t delay = etch_scan_plan(&square, write + 1, 10);

        etch_panel_clock(&port.panel, clocks[i], 1);
        if (delay < 0) {
            for (int64_t d = 0; d < 33000; d += 3300)
                CHECK(torn_at(&scan, d, number++) > 0);
            continue;
        }
        planned++;
        CHECK_EQ(torn_at(&scan, delay, number++), 0);
        CHECK(torn_at(&scan, delay + (delay == 0 ? 1000 : -800), number++) > 0);
    }
    CHECK_EQ(planned, 4);
    etch_panel_port_close(&port);
}

/* Turned by a half the frame runs against the scan and tears; with the scan turned as well it
 * does not. By a quarter it runs across and tears. */
static void the_scan_can_follow_the_frame(void)
{
    static const struct {
        uint8_t turn;
        bool up, torn;
    } cases[] = {{2, false, true}, {2 + ETCH_LCD_FOLLOW_SCAN, true, false}, {1, false, true}};

    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        if (!CHECK_EQ(etch_panel_port_open(&port, "st7789-240x240", cases[i].turn), 0))
            return;
        const struct etch_panel_scan scan = scan_of(&square, (port.panel.orient & 0x10) != 0);

        CHECK_EQ(scan.up, cases[i].up);
        etch_panel_clock(&port.panel, 80000000, 1);
        CHECK_EQ(torn_at(&scan, etch_scan_plan(&square, 11525, 10), 1) > 0, cases[i].torn);
        panel_check(&port, 1);
        etch_panel_port_close(&port);
    }
}

/* What an application gives as setup.sync: waits for the pulse of the tearing-effect line, which
 * the driver must have switched on, and then as long as the plan says. */
static int wait_for_scan(const struct etch_display *d)
{
    const struct etch_panel_scan scan = scan_of(&square, false);
    const int32_t delay = etch_scan_plan(&square, 23067, 10); /* 240 rows at 40 MHz */

    (void)d;
    if (!port.panel.pulses || delay < 0)
        return ETCH_EIO;
    etch_panel_elapse(&port.panel, etch_panel_until_pulse(&port.panel, &scan));
    etch_panel_elapse(&port.panel, (uint64_t)delay * 1000);
    return 0;
}

/* A panel opened with it shows frame after frame whole, however they follow one another; a restart
 * keeps the line on. Without it the line is off. */
static void a_panel_waits_for_its_line(void)
{
    const struct etch_lcd_setup setup = {.sync = wait_for_scan};
    const struct etch_panel_scan scan = scan_of(&square, false);

    if (!CHECK_EQ(etch_panel_port_open(&port, "st7789-240x240", 0), 0))
        return;
    CHECK(!port.panel.pulses);
    CHECK_EQ(etch_lcd_open(&port.lcd, &etch_st7789_240x240, &port.bus.bus, setup), 0);
    CHECK_EQ(etch_lcd_restart(&port.lcd), 0);
    etch_panel_clock(&port.panel, 40000000, 1);
    for (int number = 1; number <= 12; number++) {
        etch_panel_elapse(&port.panel, (uint64_t)number * 1234567);
        etch_panel_begin_changes(&port.panel);
        CHECK_EQ(panel_frame(&port, number, 240, 1), 0);
        CHECK_EQ(etch_panel_torn(&port.panel, &scan), 0);
        panel_check(&port, number);
    }
    etch_panel_port_close(&port);
}

static int synced, sync_status;

static int sync(const struct etch_display *d)
{
    (void)d;
    synced++;
    return sync_status;
}

/* The loop asks the display once a frame, before the first strip goes, and reports its error. */
static void the_loop_asks_when_to_begin(void)
{
    if (!CHECK_EQ(etch_panel_port_open(&port, "ssd1351", 0), 0))
        return;
    port.lcd.display.sync = sync;
    synced = sync_status = 0;
    CHECK_EQ(panel_frame(&port, 1, 16, 2), 0);
    CHECK_EQ(synced, 1);
    panel_check(&port, 1);
    sync_status = -55;
    etch_panel_count(&port.panel);
    CHECK_EQ(panel_frame(&port, 2, 16, 2), -55);
    CHECK_EQ(port.panel.transactions, 0);
    etch_panel_port_close(&port);
}

void suite_panel_scan(void)
{
    RUN(plans_are_safe_and_found_if_there_are_any);
    RUN(a_frame_begun_as_planned_does_not_tear);
    RUN(the_scan_can_follow_the_frame);
    RUN(a_panel_waits_for_its_line);
    RUN(the_loop_asks_when_to_begin);
}
