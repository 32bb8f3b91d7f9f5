/* ports/spi_lcd/ili9488.c: ILI9488, 320 x 480, which takes 18 bits a pixel on SPI. Tables for
 * lcd.c. Values as TFT_eSPI and J. Burkett's driver both set them; power and gamma vary by
 * module. */
#include "panels.h"

/* clang-format off */
static const uint8_t init[] = {
    ETCH_LCD_DELAY, 0x01, 120, /* software reset */
    2, 0xC0, 0x17, 0x15,       /* 5 V and -5 V references */
    1, 0xC1, 0x41,             /* step-up factors */
    3, 0xC5, 0x00, 0x12, 0x80, /* VCOM */
    1, 0x3A, 0x66,             /* 18 bits a pixel */
    1, 0xB0, 0x00,             /* bus mode */
    1, 0xB1, 0xA0,             /* 60 frames a second */
    1, 0xB4, 0x02,             /* dot inversion */
    3, 0xB6, 0x02, 0x02, 0x3B, /* 480 lines, both scans forwards */
    1, 0xB7, 0xC6,             /* entry mode: no low-voltage detection */
    1, 0xE9, 0x00,             /* of 24 bits a pixel the upper 6 of each 8 count */
    4, 0xF7, 0xA9, 0x51, 0x2C, 0x82, /* adjustment 3: loosely packed pixels */
    /* gamma, positive and negative */
    15, 0xE0, 0x00, 0x03, 0x09, 0x08, 0x16, 0x0A, 0x3F, 0x78, 0x4C, 0x09, 0x0A, 0x08, 0x16, 0x1A,
        0x0F,
    15, 0xE1, 0x00, 0x16, 0x19, 0x03, 0x0F, 0x05, 0x32, 0x45, 0x46, 0x04, 0x0E, 0x0D, 0x35, 0x37,
        0x0F,
    1, 0x53, 0x24,             /* brightness by command 51 */
    1, 0x51, 0xFF,
    ETCH_LCD_DELAY, 0x11, 120, /* wake up */
    ETCH_LCD_END,
};
/* clang-format on */

const struct etch_lcd_panel etch_ili9488 = {
    .controller = &etch_lcd_dcs_rgb666,
    .init = init,
    .width = 320,
    .height = 480,
    .memory_width = 320,
    .memory_height = 480,
    .mount = ETCH_LCD_FLIP_COLUMNS,
    .bgr = true,
};
