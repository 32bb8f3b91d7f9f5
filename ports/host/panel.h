/* ports/host/panel.h: a simulated panel. Takes the bytes of a bus, keeps the controller's memory,
 * tells what the glass shows, and refuses what the controller does not allow.
 *
 *      etch_panel_open(&panel, etch_panel_find("ili9341"))
 *      reset, select, command, data ..         by panel_bus.h, or by your own driver's mock of SPI
 *      panel.error[0] != 0                     something was illegal: a sentence
 *      etch_panel_view(&panel, turn, x, y)     0xRRGGBB, as a viewer sees frame pixel (x, y)
 *
 * It is written apart from the drivers and shares no table with ports/spi_lcd. Refused: data
 * or commands without select, data that no command asked for, a wrong number of parameters, half
 * a pixel, a window outside the memory or upside down, more pixels than the window holds, pixels
 * in a format that the controller does not take, commands too soon after reset or waking up, and
 * set-up commands that are locked. The first error stays; nothing after it is believed.
 * Not simulated, and so without effect: scrolling, partial and idle mode, gamma and voltages, and
 * the offset of lines (D3 of SSD1306, A2 of SSD1351). */
#ifndef ETCH_HOST_PANEL_H
#define ETCH_HOST_PANEL_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum etch_panel_family {
    ETCH_PANEL_DCS,
    ETCH_PANEL_SSD1351,
    ETCH_PANEL_SSD1306,
    ETCH_PANEL_SSD0323
};

/* A glass on a controller, as they leave the factory. */
struct etch_panel_type {
    const char *name;
    enum etch_panel_family family;
    int16_t width, height;               /* glass, upright */
    int16_t memory_width, memory_height; /* pixels */
    int16_t column, row;            /* least memory column and row that it shows; SSD0323: least
                                            line of the controller that is on the glass */
    bool flips_columns, flips_rows; /* memory column 0 is at its right; row 0 at its bottom */
    bool bgr, inverts;              /* filters blue first; a 0 is white */
    bool only_rgb666;
    bool has_c0; /* ST7789: command C0 exchanges bits of 36; its 20 as it is after a reset: none */
};

enum {
    ETCH_PANEL_PARAMETERS = 16
};

struct etch_panel {
    const struct etch_panel_type *type;
    uint32_t *memory; /* 0xRRGGBB a pixel, in the order sent; rows of memory_width */

    /* What arrived so far. */
    uint64_t transactions, commands, parameters, pixels, bytes;
    uint64_t now_ns; /* advanced by etch_panel_elapse */

    /* Time of a byte on the bus; 0: none. Set it with etch_panel_clock. */
    uint64_t byte_ps, picoseconds;

    char error[160]; /* the first; "" if none */

    /* The controller. */
    bool selected, in_reset, asleep, on, inverted, all_off, pumped, unlocked;
    bool pulses;                /* the tearing-effect line is on */
    uint64_t ready_ns, wake_ns; /* before these no command, no waking up */
    uint8_t orient, mode, mux, format, brightness;
    uint8_t lcm;           /* parameter of C0 */
    uint8_t offset, start; /* of lines, SSD0323; memory row of the first line, SSD1351 and 1306 */
    int command;           /* whose parameters arrive; -1: none yet */
    uint8_t parameter[ETCH_PANEL_PARAMETERS];
    int count, wanted; /* parameters that came, and must come; wanted < 0: any number */
    bool writes;       /* data are pixels */
    bool broken;       /* some will not come */
    bool has_window;
    uint8_t part[3]; /* of a pixel */
    int parts;
    int x0, y0, x1, y1; /* window, inclusive, in the controller's addresses */
    int x, y;           /* the next */
    uint32_t room;      /* pixels, or bytes, left in the window */

    /* Scan: see panel_scan.h. */
    uint64_t *changed_first, *changed_last; /* of each memory row, in this frame; 0: did not */
};

/* The types there are; NULL if the name is unknown. etch_panel_types ends with a NULL name. */
extern const struct etch_panel_type etch_panel_types[];
const struct etch_panel_type *etch_panel_find(const char *name);

/* A panel with noise in its memory, as after power-up, not reset yet. False: no memory. */
bool etch_panel_open(struct etch_panel *panel, const struct etch_panel_type *type);
void etch_panel_close(struct etch_panel *panel);

/* Time on the bus: clock in Hz, bits at a time (1 SPI, 8 parallel). */
void etch_panel_clock(struct etch_panel *panel, uint32_t clock, uint8_t bits);
void etch_panel_elapse(struct etch_panel *panel, uint64_t ns);

/* The pins. */
void etch_panel_reset(struct etch_panel *panel, bool active);
void etch_panel_select(struct etch_panel *panel, bool selected);
void etch_panel_command(struct etch_panel *panel, uint8_t byte); /* D/C low */
void etch_panel_data(struct etch_panel *panel, uint8_t byte);    /* D/C high */

/* The bus broke off: what is half sent is no error of the driver. SSD1306 and SSD0323 take the next
 * bytes for the parameters that are missing, which then have no effect. */
void etch_panel_interrupt(struct etch_panel *panel);

/* What is seen at (x, y) of the upright glass; and by a viewer who turned it by `turn` quarters
 * (plus 4: in a mirror, left and right; plus 8: top and bottom) at (x, y) of what is then the
 * frame. 0xRRGGBB; black while asleep or off. */
uint32_t etch_panel_glass(const struct etch_panel *panel, int x, int y);
uint32_t etch_panel_view(const struct etch_panel *panel, uint8_t turn, int x, int y);

/* Forgets the counts. */
void etch_panel_count(struct etch_panel *panel);

/* ---- between the files of the panel -----------------------------------------------------------
 */

/* Keeps the first error. */
void etch_panel_refuse(struct etch_panel *panel, const char *format, ...)
#if defined(__GNUC__)
    __attribute__((format(printf, 2, 3)))
#endif
    ;
/* How many parameters a command takes, -1: any; -2: pixels follow; -3: there is no such one. */
int etch_panel_parameters(const struct etch_panel *panel, uint8_t command);
/* A command with all its parameters. */
void etch_panel_execute(struct etch_panel *panel);
/* The state after a reset. */
void etch_panel_initial(struct etch_panel *panel);
/* A byte of pixels. */
void etch_panel_write(struct etch_panel *panel, uint8_t byte);
/* Sets the window and begins to write into it at its start. */
void etch_panel_window(struct etch_panel *panel);
/* The same for one side of it, which sets the address counter of that side alone. */
void etch_panel_range(struct etch_panel *panel, bool columns);

#endif
