/* ports/spi_lcd/ssd1306.c: SSD1306, black-and-white OLED of 128 columns. Tables for lcd.c. Values
 * as Adafruit's driver and A. Dynda's both set them. A byte is 8 rows of a column; addresses always
 * name the memory. */
#include "panels.h"

/* clang-format off */
static const uint8_t init_64[] = {
    0, 0xAE,       /* off while the supply is set */
    1, 0xD5, 0x80, /* clock, undivided */
    1, 0xA8, 0x3F, /* 64 lines, */
    1, 0xDA, 0x12, /* odd and even ones apart */
    1, 0xD3, 0x00, /* the first is line 0 */
    0, 0x40,
    1, 0x8D, 0x14, /* charge pump */
    1, 0xD9, 0xF1, /* pre-charge of 1 and 15 clocks */
    1, 0xDB, 0x40, /* VCOMH */
    1, 0x81, 0xCF, /* contrast */
    0, 0xA4,       /* show the memory */
    ETCH_LCD_END,
};
/* clang-format on */

/* clang-format off */
static const uint8_t init_32[] = {
    0, 0xAE,       /* as above, but: */
    1, 0xD5, 0x80,
    1, 0xA8, 0x1F, /* 32 lines, */
    1, 0xDA, 0x02, /* one after the other */
    1, 0xD3, 0x00,
    0, 0x40,
    1, 0x8D, 0x14,
    1, 0xD9, 0xF1,
    1, 0xDB, 0x40,
    1, 0x81, 0x8F, /* fewer lines, each lit for longer: less contrast */
    0, 0xA4,
    ETCH_LCD_END,
};
/* clang-format on */

/* Columns and lines counted from the end, and which of columns and pages is counted first. */
static int turn(struct etch_lcd *lcd)
{
    const bool columns = (lcd->orientation & ETCH_LCD_FLIP_COLUMNS) != 0;
    const bool rows = (lcd->orientation & ETCH_LCD_FLIP_ROWS) != 0;
    const uint8_t mode = (lcd->orientation & ETCH_LCD_SWAP) != 0 ? 1 : 0;
    int status = etch_lcd_command(lcd, columns ? 0xA1 : 0xA0, NULL, 0);

    if (status >= 0) {
        status = etch_lcd_command(lcd, rows ? 0xC8 : 0xC0, NULL, 0);
    }
    return status < 0 ? status : etch_lcd_command(lcd, 0x20, &mode, 1);
}

static const struct etch_lcd_controller ssd1306 = {
    .column = 0x21,
    .row = 0x22,
    .address_bytes = 1,
    .column_pixels = 1,
    .row_pixels = 8,
    .parameters_are_commands = true,
    .nop = 0xE3,
    .sleep = 0xAE,
    .wake = 0xAF,
    .off = 0xAE,
    .on = 0xAF,
    .straight = 0xA6,
    .inverted = 0xA7,
    .brightness = 0x81,
    .turn = turn,
    .convert = etch_lcd_mono,
};

const struct etch_lcd_panel etch_ssd1306 = {
    .controller = &ssd1306,
    .init = init_64,
    .width = 128,
    .height = 64,
    .memory_width = 128,
    .memory_height = 64,
    .mount = ETCH_LCD_FLIP_COLUMNS | ETCH_LCD_FLIP_ROWS,
    .align_y = 8,
};

const struct etch_lcd_panel etch_ssd1306_128x32 = {
    .controller = &ssd1306,
    .init = init_32,
    .width = 128,
    .height = 32,
    .memory_width = 128,
    .memory_height = 64,
    .mount = ETCH_LCD_FLIP_COLUMNS | ETCH_LCD_FLIP_ROWS,
    .align_y = 8,
};
