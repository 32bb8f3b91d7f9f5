/* tests/panels: prints the table of panels of ports/README.md: one frame of each through the
 * frame loop to its simulated panel, which counts. `make panels` calls it, with the check that the
 * README has what it prints. */
#include <stdio.h>

#include "hal/frame.h"
#include "ports/host/panel_port.h"

enum {
    ROWS = 16,
    CLOCK = 40000000
};

static struct etch_panel_port port;

/* Sends a frame in strips of ROWS rows and counts it; its bytes beside pixels, or -1. */
static long send_frame(void)
{
    static uint16_t buffer[2][480 * ROWS];
    const struct etch_display *d = &port.lcd.display;
    const struct etch_frame_memory memory = {.pixels = {buffer[0], buffer[1]},
                                             .size = (uint32_t)d->width * ROWS};
    struct etch_frame frame;

    etch_panel_count(&port.panel);
    if (etch_frame_init(&frame, d, memory) < 0) {
        return -1;
    }
    for (const struct etch_surface *s = etch_frame_begin(&frame); s != NULL;
         s = etch_frame_next(&frame)) {
    }
    if (etch_frame_end(&frame) < 0 || port.panel.error[0] != 0) {
        return -1;
    }
    return (long)(port.panel.commands + port.panel.parameters);
}

static const char *format_of(const struct etch_panel_type *t)
{
    return t->only_rgb666                    ? "RGB666, 3 bytes a pixel"
           : t->family == ETCH_PANEL_SSD1306 ? "black and white, dithered"
           : t->family == ETCH_PANEL_SSD0323 ? "16 greys, dithered"
                                             : "RGB565, as it lies in memory";
}

static int print_row(const struct etch_panel_type *t)
{
    const uint8_t turn = t->width < t->height ? 1 : 0;
    uint64_t from, ns, payload;
    long overhead;

    if (etch_panel_port_open(&port, t->name, turn) < 0) {
        (void)fprintf(stderr, "%s does not open\n", t->name);
        return 1;
    }
    etch_panel_clock(&port.panel, CLOCK, 1);
    overhead = send_frame(); /* the first one sets a window */
    from = port.panel.now_ns;
    overhead = overhead < 0 ? overhead : send_frame();
    ns = port.panel.now_ns - from;
    payload = port.panel.bytes - (uint64_t)overhead;
    if (overhead < 0 || (uint64_t)overhead * 100 > payload) {
        (void)fprintf(stderr, "%s: %s, %ld bytes beside %lu of pixels\n", t->name, port.panel.error,
                      overhead, (unsigned long)payload);
        return 1;
    }
    (void)printf("| `%s` | %d x %d | %s | %lu.%02lu | %lu | %lu | %ld (%lu.%02lu %%) |\n", t->name,
                 t->width, t->height, format_of(t), (unsigned long)(ns / 1000000),
                 (unsigned long)(ns / 10000 % 100), (unsigned long)port.panel.transactions,
                 (unsigned long)payload, overhead,
                 (unsigned long)((uint64_t)overhead * 10000 / payload / 100),
                 (unsigned long)((uint64_t)overhead * 10000 / payload % 100));
    etch_panel_port_close(&port);
    return 0;
}

int main(void)
{
    int failed = 0;

    (void)printf(
        "| panel | glass | pixels on the bus | frame, ms | transactions | bytes of pixels | "
        "other bytes |\n|---|---|---|---|---|---|---|\n");
    for (const struct etch_panel_type *t = etch_panel_types; t->name != NULL; t++) {
        failed += print_row(t);
    }
    return failed != 0;
}
