/* ports/host/screen.h: the displays of the simulator, by name.
 *
 *      memory    linear memory, drawn into directly (ports/framebuffer)
 *      strips    a panel with its own memory, fed by strips from two buffers; a transfer takes
 *                place when it is waited for, so a buffer that is drawn on too early shows
 *      strips1   the same with one buffer
 *      ili9341.. the panels of ports/spi_lcd: the frame goes through the panel's driver and a bus
 *                to a simulated panel (panel.h), which decodes the bytes; what is seen on its
 *                glass is the frame (screen_panel.c)
 */
#ifndef ETCH_HOST_SCREEN_H
#define ETCH_HOST_SCREEN_H

#include "../framebuffer/framebuffer.h"
#include "panel_port.h"
#include "text.h"

/* What a panel's port can be told. */
struct etch_screen_panel {
    int8_t turn;     /* quarters clockwise; -1: the least with which the frame has its size */
    uint8_t mirror;  /* ETCH_LCD_MIRROR_X, _Y: how glass and viewer are mirrored */
    uint8_t buffers; /* of strips, 1 or 2 */
    uint32_t clock;  /* of the bus, Hz */
    uint8_t lanes;   /* bits that it moves in a clock: 1 SPI, 4 quad SPI, 8 parallel */
};

struct etch_screen {
    struct etch_display display;
    uint8_t buffers;               /* 0 direct, else how many the frame loop is given */
    struct etch_framebuffer shown; /* what is on the glass */
    bool swapped;                  /* whose words are rgb565_swapped */
    uint64_t bytes, flushes;       /* sent so far */

    struct etch_panel_port *panel; /* NULL: not one of ports/spi_lcd */
    uint64_t opened_ns;            /* on the panel's clock */

    /* The transfer that has not taken place yet; pixels NULL: none. */
    const uint16_t *pixels;
    struct etch_rect area;
    uint16_t stride;
};

/* Makes a black screen. False, with the reason in *error, which names `path`: the name is unknown,
 * a panel has another size, or there is no memory. Close in both cases. */
bool etch_screen_open(struct etch_screen *screen, const char *name,
                      const struct etch_display *frame, const struct etch_screen_panel *panel,
                      const char *path, struct etch_error *error);

/* The format (enum etch_format) in which a port wants its pixels; -1: any. */
int etch_screen_format(const char *name);

/* After the frame: what a panel's glass shows goes to `shown`, its counts to bytes and flushes.
 * False, with the reason in *error, if something on the bus was illegal. */
bool etch_screen_look(struct etch_screen *screen, const char *path, struct etch_error *error);

/* Gives the memory back. The screen must stay where it was opened. */
void etch_screen_close(struct etch_screen *screen);

/* The names, with blanks between, from malloc; NULL without memory. */
char *etch_screen_names(void);

/* ---- between screen.c and screen_panel.c -------------------------------------------------------
 */

bool etch_screen_open_panel(struct etch_screen *screen, const struct etch_panel_type *type,
                            const struct etch_display *frame,
                            const struct etch_screen_panel *settings, const char *path,
                            struct etch_error *error);
void etch_screen_close_panel(struct etch_screen *screen);

#endif
