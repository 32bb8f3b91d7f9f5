/* ports/spi_lcd/dcs.h: the commands that most colour controllers share (MIPI Alliance, Display
 * Command Set), as the first members of a controller's table. */
#ifndef ETCH_PORTS_SPI_LCD_DCS_H
#define ETCH_PORTS_SPI_LCD_DCS_H

#include "panels.h"

/* clang-format off */
#define ETCH_LCD_DCS                                                                      \
    .column = 0x2A, .row = 0x2B, .write = 0x2C,                                           \
    .address_bytes = 2, .column_pixels = 1, .row_pixels = 1, .addresses_turn = true,      \
    .orient = 0x36, .flip_columns = 0x40, .flip_rows = 0x80, .swap = 0x20, .bgr = 0x08,   \
    .scan_up = 0x10, .turn = etch_lcd_orient,                                             \
    .sleep = 0x10, .wake = 0x11, .off = 0x28, .on = 0x29,                                 \
    .straight = 0x20, .inverted = 0x21, .tearing = 0x35
/* clang-format on */

#endif
