/* ports/spi_lcd/lcd.h: SPI panels with a memory of their own.
 *
 *      static struct etch_lcd lcd;
 *      status = etch_lcd_open(&lcd, &etch_ili9341, &bus, (struct etch_lcd_setup){.turn = 1});
 *      status = etch_frame_init(&frame, &lcd.display, memory);
 *
 * One small core (this file) and one file a controller, which is tables: what its commands are
 * called (struct etch_lcd_controller) and how a glass is bonded to it (struct etch_lcd_panel). A
 * panel that is not listed is one such table more; copy the nearest and change what differs,
 * the init table included. A controller of a new kind may bring its own `send` and `orient`.
 *
 * Where a pixel goes. The panel's memory has memory_width x memory_height pixels; the glass shows
 * a part of it. Three switches, the orientation, lead from the frame to the memory:
 *
 *      SWAP          frame x runs along memory rows           (0x20 of command 36, "MV")
 *      FLIP_COLUMNS  memory columns are counted from the end  (0x40, "MX")
 *      FLIP_ROWS     memory rows are counted from the end     (0x80, "MY")
 *
 *      turn 0, 1, 2, 3: the flips of the upright glass ("mount") exclusive-or
 *                       nothing, SWAP + FLIP_COLUMNS, FLIP_COLUMNS + FLIP_ROWS, SWAP + FLIP_ROWS
 *
 * The offset of the glass in the memory, counted from the end that the flips select, is added to
 * every address; so one pair (column, row) a panel gives the offsets of all rotations.
 */
#ifndef ETCH_PORTS_SPI_LCD_LCD_H
#define ETCH_PORTS_SPI_LCD_LCD_H

#include "../../hal/bus.h"
#include "../../hal/display.h"

enum etch_lcd_orientation {
    ETCH_LCD_FLIP_COLUMNS = 1,
    ETCH_LCD_FLIP_ROWS = 2,
    ETCH_LCD_SWAP = 4
};

/* What the frame is on the glass: turned clockwise by 0, 1, 2 or 3 quarters, plus any of: */
enum etch_lcd_turn {
    ETCH_LCD_MIRROR_X = 4,    /* left and right of the turned frame exchanged (a view through a
                                mirror or a prism) */
    ETCH_LCD_MIRROR_Y = 8,    /* top and bottom */
    ETCH_LCD_FOLLOW_SCAN = 16 /* the panel refreshes from the end that the frame's top is at, if
                                the controller can; see hal/scan.h. Without a swap only */
};

struct etch_lcd;

/* A controller: its commands. Constant. */
struct etch_lcd_controller {
    /* Window: `column` first last, `row` first last, then `write` (0: data follow at once). */
    uint8_t column, row, write;
    uint8_t address_bytes;             /* of first and of last: 1 or 2 */
    uint8_t column_pixels, row_pixels; /* that one address counts: 2 x 1 for two in a byte */

    bool parameters_are_commands; /* they go with D/C low */
    bool addresses_turn;          /* the orientation acts on addresses, not on the glass */
    bool needs_scratch;           /* `send` converts pixels */

    /* Orientation: command `orient`, value base, with the bits below exchanged. */
    uint8_t orient, base, flip_columns, flip_rows, swap, bgr, scan_up;

    /* Commands without parameters; brightness has one of a byte. 0: has none. */
    uint8_t sleep, wake, off, on, straight, inverted, brightness;
    uint8_t brightness_shift; /* to the right, of 0 .. 255 */

    /* Sends the orientation; and the pixels of an area, the last bytes of which may still be
     * under way on return. Called within a transaction, with the window set. */
    int (*turn)(struct etch_lcd *lcd);
    int (*send)(struct etch_lcd *lcd, struct etch_rect area, const uint16_t *pixels,
                uint16_t stride);
};

/* A glass on a controller. Constant. */
struct etch_lcd_panel {
    const struct etch_lcd_controller *controller;
    const uint8_t *init;                 /* see ETCH_LCD_END */
    int16_t width, height;               /* of the glass, at turn 0 */
    int16_t memory_width, memory_height; /* that the orientation flips; at least the glass */
    int16_t column, row;                 /* in memory of the glass' first column and row */
    uint8_t mount;                       /* FLIP_COLUMNS, FLIP_ROWS that make turn 0 upright */
    bool bgr;                            /* the glass has blue where the controller has red */
    bool inverted;                       /* a straight picture needs the inverting command */
    uint8_t align_x, align_y;            /* pixels of the unturned frame that share a byte */
};

/* Init tables: for each command  {count, command, parameter ..}, with ETCH_LCD_DELAY added to the
 * count {.., milliseconds}; at the end ETCH_LCD_END. The table wakes the panel up (with the delay
 * its data sheet asks for) but does not switch the display on: etch_lcd_open clears the memory
 * first, so that nobody sees what was in it. */
#define ETCH_LCD_DELAY 0x80
#define ETCH_LCD_END 0x7F

struct etch_lcd_setup {
    uint8_t turn;          /* enum etch_lcd_turn */
    uint8_t *scratch;      /* the caller's, for controllers that do not take RGB565 (ILI9488,
                              SSD1306, SSD0323), else NULL: converted pixels wait here, one half
                              is filled while the other is sent. It stays in use */
    uint16_t scratch_size; /* bytes, at least 12; from 128 on nothing is gained */
};

/* A panel. Set up by etch_lcd_open; then `display` is what the frame loop wants and the rest
 * private. Must stay where it is. */
struct etch_lcd {
    struct etch_display display;
    const struct etch_lcd_panel *panel;
    const struct etch_bus *bus;
    struct etch_lcd_setup setup;
    uint8_t orientation;
    int16_t column, row;     /* added to addresses: along the frame's x and y if addresses turn,
                                else along the memory's */
    struct etch_rect window; /* what the panel goes on to fill without a new window, or empty */
    bool sending;
};

/* Resets the panel, runs its init table, clears it to black and switches it on. Takes what the
 * data sheets ask for, 130 to 400 ms, and a frame's time for clearing. Calls the bus outside of
 * any other transaction.
 * 0, or the bus's error, or ETCH_ENOMEM: the controller needs a larger scratch buffer. */
int etch_lcd_open(struct etch_lcd *lcd, const struct etch_lcd_panel *panel,
                  const struct etch_bus *bus, struct etch_lcd_setup setup);

/* Turns the frame, between two frames; width and height of the display change, so
 * etch_frame_init comes next. What is on the glass stays as it is, or is mirrored, until drawn
 * over. */
int etch_lcd_turn(struct etch_lcd *lcd, uint8_t turn);

/* The display's settings, between two frames; in lcd_set.c. 0, the bus's error, or ETCH_EINVAL:
 * the controller cannot. Sleep stops the panel's supply and takes 5 ms, waking 120 ms; the
 * memory keeps the picture. Brightness 0 .. 255 is the contrast current of an OLED; of an LCD it
 * is a pin that drives the backlight, if the module connects it. */
int etch_lcd_show(struct etch_lcd *lcd, bool on);
int etch_lcd_sleep(struct etch_lcd *lcd, bool asleep);
int etch_lcd_invert(struct etch_lcd *lcd, bool inverted);
int etch_lcd_brightness(struct etch_lcd *lcd, uint8_t value);

/* The display's functions, reached through `display`. */
int etch_lcd_flush(const struct etch_display *display, struct etch_rect area,
                   const uint16_t *pixels, uint16_t stride);
int etch_lcd_wait(const struct etch_display *display);

/* ---- for controllers ----------------------------------------------------------------------- */

/* Sends a command with n parameters. Within a transaction. */
int etch_lcd_command(struct etch_lcd *lcd, uint8_t command, const uint8_t *parameters, uint8_t n);

/* Sends data in parts that the bus takes; the last may be under way on return. Whoever sends
 * after other data waits first. */
int etch_lcd_data(struct etch_lcd *lcd, const uint8_t *bytes, uint32_t n);

/* `turn` by the table; in lcd_open.c. */
int etch_lcd_orient(struct etch_lcd *lcd);

/* `send` of RGB565, high byte first, as it lies in memory: one transfer if the rows are
 * adjacent, else one for each. */
int etch_lcd_send_rgb565(struct etch_lcd *lcd, struct etch_rect area, const uint16_t *pixels,
                         uint16_t stride);

/* 8-bit rrrrrr00 gggggg00 bbbbbb00; 5 bits become 6 by repeating the first. */
int etch_lcd_send_rgb666(struct etch_lcd *lcd, struct etch_rect area, const uint16_t *pixels,
                         uint16_t stride);

/* 16 grey levels, two pixels a byte, the left or upper one high; and black and white, 8 pixels a
 * byte, the left or upper one low. Luminance (77 r + 150 g + 29 b) / 256 of 8-bit channels, by
 * ordered dithering with an 8 x 8 matrix fixed to the frame, so neither strips nor rectangles
 * change a pixel. Source: B. Bayer, An optimum method for two-level rendition of continuous-tone
 * pictures, 1973. About 30 instructions a pixel. */
int etch_lcd_send_gray4(struct etch_lcd *lcd, struct etch_rect area, const uint16_t *pixels,
                        uint16_t stride);
int etch_lcd_send_mono(struct etch_lcd *lcd, struct etch_rect area, const uint16_t *pixels,
                       uint16_t stride);

#endif
