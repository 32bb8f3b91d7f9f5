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
struct etch_lcd_pixels;

/* A controller: its commands. Constant. */
struct etch_lcd_controller {
    /* Window: `column` first last, `row` first last, then `write` (0: data follow at once). */
    uint8_t column, row, write;
    uint8_t address_bytes;             /* of first and of last: 1 or 2 */
    uint8_t column_pixels, row_pixels; /* that one address counts: 2 x 1 for two in a byte */

    bool parameters_are_commands; /* they go with D/C low; then `nop` is a command without effect */
    bool addresses_turn;          /* the orientation acts on addresses, not on the glass */

    /* Orientation: command `orient`, value base, with the bits below exchanged. */
    uint8_t orient, base, flip_columns, flip_rows, swap, bgr, scan_up;

    /* Commands without parameters; brightness has one of a byte. 0: has none. */
    uint8_t sleep, wake, off, on, straight, inverted, brightness;
    uint8_t brightness_shift; /* to the right, of 0 .. 255 */
    uint8_t nop;
    uint8_t tearing; /* switches the tearing-effect line on; has a parameter of 0 */

    /* Sends the orientation. Called within a transaction. */
    int (*turn)(struct etch_lcd *lcd);

    /* NULL: pixels are sent as they lie in memory, RGB565 with the high byte first. Else writes
     * pixels from (s->x, s->y) on, row after row, as the controller takes them, to at most `room`
     * bytes, 6 or more, and moves (x, y) on. Returns the bytes written, 0 at the end. Called in the
     * bus's interrupt if it has one: touches nothing but `s` and `to`. */
    uint16_t (*convert)(struct etch_lcd_pixels *s, uint8_t *to, uint16_t room);
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
    uint8_t align_x, align_y;            /* pixels of the unturned frame that share a byte; width
                                            and height are multiples of them */
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
                              is filled, in the bus's interrupt if it has one, while the other is
                              sent. It stays in use, and where DMA can read it */
    uint16_t scratch_size; /* bytes, at least 12. An interrupt takes as long as half of them: see
                              `convert` below; 128 are enough for few interrupts */
    int (*sync)(const struct etch_display *display); /* NULL, or becomes the display's, which see;
                              the controller's tearing-effect line is then on, if it has one */
};

/* The pixels of a strip on their way. The thread's until the bus begins to send, then the bus's. */
struct etch_lcd_pixels {
    struct etch_pieces pieces; /* first */
    const struct etch_lcd *lcd;
    struct etch_rect area;
    const uint16_t *pixels; /* (area.x0, area.y0) */
    uint16_t stride;
    int16_t x, y;      /* the next to convert, in frame coordinates */
    bool upper;        /* half of the scratch buffer that comes next */
    int16_t rows;      /* not converted: that lie together, */
    uint32_t part;     /* their bytes, */
    uint32_t left;     /* those not yet sent, */
    const uint8_t *at; /* and where */
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
    struct etch_rect window; /* without a write command: the window that is set, or empty; */
    int16_t row_next;        /* the row that the panel fills next: window.y0 .. y1; */
    bool columns_next;       /* and what of it is set anew next: see lcd.c */
    bool sending;
    bool broken;                           /* the last command failed */
    bool hidden, asleep, inverted, dimmed; /* as was asked for last, for etch_lcd_restart */
    uint8_t brightness;                    /* if dimmed */
    struct etch_lcd_pixels pixels;
};

/* Resets the panel, runs its init table, clears it to black and switches it on. Takes what the
 * data sheets ask for, 130 to 400 ms, and a frame's time for clearing. Calls the bus outside of
 * any other transaction.
 * 0, or the bus's error, or ETCH_ENOMEM: the controller needs a larger scratch buffer. */
int etch_lcd_open(struct etch_lcd *lcd, const struct etch_lcd_panel *panel,
                  const struct etch_bus *bus, struct etch_lcd_setup setup);

/* The same again with the turn and the settings below as they are now: for a panel that lost its
 * own, by a supply that sagged, a plug that was pulled, or noise. After a frame that failed nothing
 * is needed, as the next begins with a window; a panel cannot be asked how it is, so restart it
 * when frames go on failing, or when the application knows better. The picture is gone: draw
 * the whole frame next (etch_tiles_forget). Between two frames; 0, or the bus's error. */
int etch_lcd_restart(struct etch_lcd *lcd);

/* Turns the frame, between two frames; width and height of the display change, so
 * etch_frame_init comes next. What is on the glass stays as it is, or is mirrored, until drawn
 * over. */
int etch_lcd_turn(struct etch_lcd *lcd, uint8_t turn);

/* The display's settings, between two frames; in lcd_set.c. 0, the bus's error, or ETCH_EINVAL:
 * the controller cannot. Sleep stops the panel's supply; it takes 120 ms, and so does waking, as
 * data sheets ask between the two. The memory keeps the picture. Brightness 0 .. 255 is the
 * contrast current of an OLED, in as many steps as it has; of an LCD it is a pin that drives the
 * backlight, if the module connects it. */
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

/* `turn` by the table; in lcd_open.c. */
int etch_lcd_orient(struct etch_lcd *lcd);

/* The pixels of an area as pieces for the bus; in lcd_pixels.c. */
struct etch_pieces *etch_lcd_pixels(struct etch_lcd *lcd, struct etch_rect area,
                                    const uint16_t *pixels, uint16_t stride);

/* `convert`: a byte a channel, whose upper six bits count; 5 bits become 6 by repeating the first.
 * 19 instructions a pixel on Cortex-M0+, of 24 clocks on the bus; with a scratch buffer of 128 an
 * interrupt converts 21. */
uint16_t etch_lcd_rgb666(struct etch_lcd_pixels *s, uint8_t *to, uint16_t room);

/* `convert`: 16 grey levels, two pixels a byte, the left or upper one high; and black and white, 8
 * pixels a byte, the left or upper one low. Luminance (77 r + 150 g + 29 b) / 256 of 8-bit
 * channels, by ordered dithering with an 8 x 8 matrix fixed to the frame, so neither strips nor
 * rectangles change a pixel. Source: B. Bayer, An optimum method for two-level rendition of
 * continuous-tone pictures, 1973. On Cortex-M0+ about 105 instructions a pixel of grey, 92 of black
 * and white, 740 a byte: more than the bus needs, so the program pays for it wherever it happens.
 * Where long interrupts hurt, a scratch buffer of 12 bytes makes them short. */
uint16_t etch_lcd_gray4(struct etch_lcd_pixels *s, uint8_t *to, uint16_t room);
uint16_t etch_lcd_mono(struct etch_lcd_pixels *s, uint8_t *to, uint16_t room);

/* The row of the next pixel. */
ETCH_INLINE const uint16_t *etch_lcd_row(const struct etch_lcd_pixels *s)
{
    return s->pixels + (size_t)(s->y - s->area.y0) * s->stride;
}

/* dx pixels on in the row, or dy rows down if it has ended. */
ETCH_INLINE void etch_lcd_advance(struct etch_lcd_pixels *s, int16_t dx, int16_t dy)
{
    s->x = (int16_t)(s->x + dx);
    if (s->x >= s->area.x1) {
        s->x = s->area.x0;
        s->y = (int16_t)(s->y + dy);
    }
}

/* A pixel of the buffer as 0brrrrrggggggbbbbb. */
ETCH_INLINE uint16_t etch_lcd_color(uint16_t pixel)
{
    return ETCH_FORMAT_HIGH_BYTE_FIRST == ETCH_FORMAT_RGB565 ? pixel : etch_rgb565_swap(pixel);
}

#endif
