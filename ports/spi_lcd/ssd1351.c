/* ports/spi_lcd/ssd1351.c: SSD1351, colour OLED of 128 x 128. Tables for lcd.c. Values as
 * TFT_eSPI and Adafruit's driver both set them, bits of A0 included. Addresses always name the
 * memory; a turned frame is written with the rows counted first. */
#include "panels.h"

/* clang-format off */
static const uint8_t init[] = {
    1, 0xFD, 0x12,             /* unlock the commands, */
    1, 0xFD, 0xB1,             /* and those of set-up */
    0, 0xAE,                   /* asleep while the supply is set */
    1, 0xB3, 0xF1,             /* clock: fastest, divided by 2 */
    1, 0xCA, 0x7F,             /* 128 lines */
    1, 0xA1, 0x00,             /* the first is line 0 */
    1, 0xA2, 0x00,
    1, 0xB5, 0x00,             /* pins unused */
    1, 0xAB, 0x01,             /* internal supply */
    1, 0xB1, 0x32,             /* phases of 5 and 6 clocks, */
    1, 0xB6, 0x01,             /* the second pre-charge of 1 */
    1, 0xBE, 0x05,             /* VCOMH 0.82 VCC */
    3, 0xC1, 0xC8, 0x80, 0xC8, /* currents of the three colours */
    1, 0xC7, 0x0F,             /* not reduced */
    3, 0xB4, 0xA0, 0xB5, 0x55, /* external VSL */
    ETCH_LCD_END,
};
/* clang-format on */

static const struct etch_lcd_controller ssd1351 = {
    .column = 0x15,
    .row = 0x75,
    .write = 0x5C,
    .address_bytes = 1,
    .column_pixels = 1,
    .row_pixels = 1,
    .orient = 0xA0,
    .base = 0x70, /* 65k colours, odd and even lines split, scanned from the last */
    .flip_columns = 0x02,
    .flip_rows = 0x10,
    .swap = 0x01,
    .bgr = 0x04,
    .sleep = 0xAE,
    .wake = 0xAF,
    .off = 0xAE,
    .on = 0xAF,
    .straight = 0xA6,
    .inverted = 0xA7,
    .brightness = 0xC7,
    .brightness_shift = 4, /* 16ths of the colours' currents */
    .turn = etch_lcd_orient,
};

const struct etch_lcd_panel etch_ssd1351 = {
    .controller = &ssd1351,
    .init = init,
    .width = 128,
    .height = 128,
    .memory_width = 128,
    .memory_height = 128,
    .bgr = true,
};
