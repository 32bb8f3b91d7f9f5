/* ports/spi_lcd/lcd.c: a panel as a display: commands, windows, frames. The frame loop calls flush
 * and wait; lcd_pixels.c hands the pixels to the bus. See lcd.h. */
#include "lcd.h"

/* Bytes in one piece. */
struct parameters {
    struct etch_pieces pieces; /* first */
    const uint8_t *bytes;
    uint8_t n;
};

static const uint8_t *next_parameters(struct etch_pieces *pieces, uint32_t *n)
{
    struct parameters *p = (struct parameters *)pieces;

    *n = p->n;
    p->n = 0;
    return *n != 0 ? p->bytes : NULL;
}

static int send_command(struct etch_lcd *lcd, uint8_t command, const uint8_t *parameters, uint8_t n)
{
    struct parameters p = {{next_parameters}, parameters, n};
    const struct etch_bus *bus = lcd->bus;
    int status = bus->command(bus, &command, 1);

    if (status < 0 || n == 0) {
        return status;
    }
    if (lcd->panel->controller->parameters_are_commands) {
        return bus->command(bus, parameters, n);
    }
    status = bus->data(bus, &p.pieces);
    return status < 0 ? status : bus->wait(bus);
}

/* A command that broke off leaves a controller whose parameters are commands waiting for them: it
 * gets 8, as many as any command has, that do nothing if none are missing. */
static int end_broken_command(struct etch_lcd *lcd)
{
    const uint8_t nop = lcd->panel->controller->nop;
    const uint8_t nops[8] = {nop, nop, nop, nop, nop, nop, nop, nop};

    return lcd->broken && nop != 0 ? lcd->bus->command(lcd->bus, nops, sizeof nops) : ETCH_OK;
}

int etch_lcd_command(struct etch_lcd *lcd, uint8_t command, const uint8_t *parameters, uint8_t n)
{
    int status = end_broken_command(lcd);

    if (status >= 0) {
        status = send_command(lcd, command, parameters, n);
    }
    lcd->broken = status < 0;
    if (lcd->broken) {
        lcd->window = (struct etch_rect){0, 0, 0, 0}; /* so that the next strip sends commands */
    }
    return status;
}

/* ---- where the frame is in memory ------------------------------------------------------------ */

static int send_range(struct etch_lcd *lcd, uint8_t command, int16_t first, int16_t last)
{
    const uint8_t wide[4] = {(uint8_t)(first >> 8 & 0xFF), (uint8_t)(first & 0xFF),
                             (uint8_t)(last >> 8 & 0xFF), (uint8_t)(last & 0xFF)};
    const uint8_t narrow[2] = {wide[1], wide[3]};

    return lcd->panel->controller->address_bytes == 2 ? etch_lcd_command(lcd, command, wide, 4)
                                                      : etch_lcd_command(lcd, command, narrow, 2);
}

enum {
    COLUMNS = 1,
    ROWS = 2
};

/* Sets the window, or one side of it. Addresses name pixels of the turned frame, or those of the
 * memory. */
static int set_window(struct etch_lcd *lcd, struct etch_rect area, int sides)
{
    const struct etch_lcd_controller *c = lcd->panel->controller;
    const bool cross = !c->addresses_turn && (lcd->orientation & ETCH_LCD_SWAP) != 0;
    const struct etch_rect a = {cross ? area.y0 : area.x0, cross ? area.x0 : area.y0,
                                cross ? area.y1 : area.x1, cross ? area.x1 : area.y1};
    int status = ETCH_OK;

    if ((sides & COLUMNS) != 0) {
        status = send_range(lcd, c->column, (int16_t)((a.x0 + lcd->column) / c->column_pixels),
                            (int16_t)((a.x1 - 1 + lcd->column) / c->column_pixels));
    }
    if (status >= 0 && (sides & ROWS) != 0) {
        status = send_range(lcd, c->row, (int16_t)((a.y0 + lcd->row) / c->row_pixels),
                            (int16_t)((a.y1 - 1 + lcd->row) / c->row_pixels));
    }
    return status < 0 || c->write == 0 ? status : etch_lcd_command(lcd, c->write, NULL, 0);
}

static void forget_window(struct etch_lcd *lcd)
{
    lcd->window = (struct etch_rect){0, 0, 0, 0};
}

/* Panels that take data without a write command get one window for all strips of a frame: it
 * reaches to the bottom, and a strip that follows the last one goes on in it. When it is full both
 * address counters are back at its start, and each range command sets its own: so one side, by
 * turns, is enough for the same window again, and heals a counter that noise put out of step. */
static int open_window(struct etch_lcd *lcd, struct etch_rect area)
{
    const struct etch_rect w = lcd->window;
    const int16_t next = lcd->row_next;
    const bool same = !etch_rect_is_empty(w) && w.x0 == area.x0 && w.x1 == area.x1;
    struct etch_rect rest = area;
    int status = ETCH_OK;

    if (lcd->panel->controller->write != 0) {
        return set_window(lcd, area, COLUMNS | ROWS);
    }
    rest.y1 = lcd->display.height;
    forget_window(lcd);
    if (same && area.y0 == next) {
        rest = w;
    } else if (same && area.y0 == w.y0 && next == w.y1) {
        status = set_window(lcd, rest, lcd->columns_next ? COLUMNS : ROWS);
        lcd->columns_next = !lcd->columns_next;
    } else {
        status = set_window(lcd, rest, COLUMNS | ROWS);
    }
    if (status >= 0) {
        lcd->window = rest;
        lcd->row_next = area.y1;
    }
    return status;
}

/* ---- the display ----------------------------------------------------------------------------- */

int etch_lcd_flush(const struct etch_display *display, struct etch_rect area,
                   const uint16_t *pixels, uint16_t stride)
{
    struct etch_lcd *lcd = display->context;
    const struct etch_bus *bus = lcd->bus;
    int status = bus->begin(bus);

    if (status < 0) {
        return status;
    }
    status = open_window(lcd, area);
    if (status >= 0) {
        status = bus->data(bus, etch_lcd_pixels(lcd, area, pixels, stride));
    }
    lcd->sending = status >= 0;
    if (status < 0) {
        forget_window(lcd);
        bus->end(bus);
    }
    return status;
}

int etch_lcd_wait(const struct etch_display *display)
{
    struct etch_lcd *lcd = display->context;
    int status = ETCH_OK;

    if (lcd->sending) {
        lcd->sending = false;
        status = lcd->bus->wait(lcd->bus);
        lcd->bus->end(lcd->bus);
    }
    if (status < 0) {
        forget_window(lcd);
    }
    return status;
}
