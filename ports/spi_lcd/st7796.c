/* ports/spi_lcd/st7796.c: ST7796S, 320 x 480, which takes RGB565 on SPI. Tables for lcd.c. Values
 * as TFT_eSPI and a Linux driver for MIPI DBI panels both set them; power and gamma vary by module.
 */
#include "panels.h"

/* clang-format off */
static const uint8_t init[] = {
    ETCH_LCD_DELAY, 0x01, 120, /* software reset */
    ETCH_LCD_DELAY, 0x11, 120, /* wake up */
    1, 0xF0, 0xC3,             /* opens the registers below, */
    1, 0xF0, 0x96,             /* in two steps */
    1, 0x3A, 0x55,             /* 16 bits a pixel */
    1, 0xB4, 0x01,             /* dot inversion */
    3, 0xB6, 0x80, 0x02, 0x3B, /* 480 lines, both scans forwards */
    8, 0xE8, 0x40, 0x8A, 0x00, 0x00, 0x29, 0x19, 0xA5, 0x33, /* timing of gates and sources */
    1, 0xC1, 0x06,             /* GVDD 3.85 V above VCOM */
    1, 0xC2, 0xA7,             /* currents: sources low, gamma high */
    1, 0xC5, 0x18,             /* VCOM 0.9 V */
    /* gamma, positive and negative */
    14, 0xE0, 0xF0, 0x09, 0x0B, 0x06, 0x04, 0x15, 0x2F, 0x54, 0x42, 0x3C, 0x17, 0x14, 0x18, 0x1B,
    14, 0xE1, 0xE0, 0x09, 0x0B, 0x06, 0x04, 0x03, 0x2B, 0x43, 0x42, 0x3B, 0x16, 0x14, 0x17, 0x1B,
    1, 0xF0, 0x3C,             /* closes them */
    1, 0xF0, 0x69,
    1, 0x53, 0x24,             /* brightness by command 51 */
    1, 0x51, 0xFF,
    ETCH_LCD_END,
};
/* clang-format on */

const struct etch_lcd_panel etch_st7796 = {
    .controller = &etch_lcd_dcs,
    .init = init,
    .width = 320,
    .height = 480,
    .memory_width = 320,
    .memory_height = 480,
    .mount = ETCH_LCD_FLIP_COLUMNS,
    .bgr = true,
};
