/* ports/spi_lcd/ili9341.c: ILI9341, 240 x 320. Tables for lcd.c. Values as TFT_eSPI and
 * Adafruit's driver both set them; power and gamma vary by module. */
#include "panels.h"

/* clang-format off */
static const uint8_t init[] = {
    ETCH_LCD_DELAY, 0x01, 120, /* software reset, for modules without a reset line */
    5, 0xCB, 0x39, 0x2C, 0x00, 0x34, 0x02, /* power control A: Vcore, DDVDH */
    3, 0xCF, 0x00, 0xC1, 0x30, /* power control B: discharge, drive */
    4, 0xED, 0x64, 0x03, 0x12, 0x81, /* order in which the supplies come up */
    3, 0xE8, 0x85, 0x00, 0x78, /* driver timing A: gates */
    2, 0xEA, 0x00, 0x00,       /* driver timing B: gates, in units */
    1, 0xF7, 0x20,             /* pump: DDVDH is twice VCI */
    1, 0xC0, 0x23,             /* GVDD 4.6 V */
    1, 0xC1, 0x10,             /* step-up factors */
    2, 0xC5, 0x3E, 0x28,       /* VCOM high and low */
    1, 0xC7, 0x86,             /* VCOM offset */
    1, 0x3A, 0x55,             /* 16 bits a pixel */
    2, 0xB1, 0x00, 0x1B,       /* 70 frames a second */
    3, 0xB6, 0x08, 0x82, 0x27, /* 320 lines */
    1, 0xF2, 0x00,             /* one gamma for the three colours */
    1, 0x26, 0x01,             /* gamma curve 1, then its points, positive and negative */
    15, 0xE0, 0x0F, 0x31, 0x2B, 0x0C, 0x0E, 0x08, 0x4E, 0xF1, 0x37, 0x07, 0x10, 0x03, 0x0E, 0x09,
        0x00,
    15, 0xE1, 0x00, 0x0E, 0x14, 0x03, 0x11, 0x07, 0x31, 0xC1, 0x48, 0x08, 0x0F, 0x0C, 0x31, 0x36,
        0x0F,
    1, 0x53, 0x24,             /* brightness by command 51 */
    1, 0x51, 0xFF,
    ETCH_LCD_DELAY, 0x11, 120, /* wake up */
    ETCH_LCD_END,
};
/* clang-format on */

const struct etch_lcd_panel etch_ili9341 = {
    .controller = &etch_lcd_dcs,
    .init = init,
    .width = 240,
    .height = 320,
    .memory_width = 240,
    .memory_height = 320,
    .mount = ETCH_LCD_FLIP_COLUMNS,
    .bgr = true,
};
