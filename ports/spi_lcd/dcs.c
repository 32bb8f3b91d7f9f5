/* ports/spi_lcd/dcs.c: the commands that most colour controllers share (MIPI Alliance, Display
 * Command Set). The panel tables refer to it. */
#include "panels.h"

const struct etch_lcd_controller etch_lcd_dcs = {
    .column = 0x2A,
    .row = 0x2B,
    .write = 0x2C,
    .address_bytes = 2,
    .column_pixels = 1,
    .row_pixels = 1,
    .addresses_turn = true,
    .orient = 0x36,
    .flip_columns = 0x40,
    .flip_rows = 0x80,
    .swap = 0x20,
    .bgr = 0x08,
    .scan_up = 0x10,
    .sleep = 0x10,
    .wake = 0x11,
    .off = 0x28,
    .on = 0x29,
    .straight = 0x20,
    .inverted = 0x21,
    .brightness = 0x51,
    .tearing = 0x35,
    .turn = etch_lcd_orient,
};
