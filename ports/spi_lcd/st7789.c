/* ports/spi_lcd/st7789.c: ST7789, whose memory of 240 x 320 serves glasses of several sizes.
 * Tables for lcd.c. Values as TFT_eSPI sets them, most of them the reset values, on which
 * Adafruit's driver relies; C0 is the reset value, so that command 36 means what it means there. */
#include "panels.h"

/* clang-format off */
static const uint8_t init[] = {
    ETCH_LCD_DELAY, 0x01, 150,             /* software reset */
    ETCH_LCD_DELAY, 0x11, 120,             /* wake up */
    1, 0x3A, 0x55,                         /* 16 bits a pixel */
    2, 0xB0, 0x00, 0xE0,                   /* high byte first; the lowest bit of 6 is the highest */
    5, 0xB2, 0x0C, 0x0C, 0x00, 0x33, 0x33, /* porches of 12 lines */
    1, 0xB7, 0x35,                         /* gate voltages */
    1, 0xBB, 0x28,                         /* VCOM 1.1 V */
    1, 0xC0, 0x2C,                         /* reset value; without 20 red and blue change places */
    2, 0xC2, 0x01, 0xFF,                   /* VDV and VRH by command: */
    1, 0xC3, 0x10,                         /* VRH */
    1, 0xC4, 0x20,                         /* VDV 0 */
    1, 0xC6, 0x0F,                         /* 60 frames a second */
    2, 0xD0, 0xA4, 0xA1,                   /* supplies */
    /* gamma, positive and negative */
    14, 0xE0, 0xD0, 0x00, 0x02, 0x07, 0x0A, 0x28, 0x32, 0x44, 0x42, 0x06, 0x0E, 0x12, 0x14, 0x17,
    14, 0xE1, 0xD0, 0x00, 0x02, 0x07, 0x0A, 0x28, 0x31, 0x54, 0x47, 0x0E, 0x1C, 0x17, 0x1B, 0x1E,
    1, 0x53, 0x24,                         /* brightness by command 51 */
    1, 0x51, 0xFF,
    0, 0x13,                               /* normal mode */
    ETCH_LCD_END,
};
/* clang-format on */

const struct etch_lcd_panel etch_st7789 = {
    .controller = &etch_lcd_dcs,
    .init = init,
    .width = 240,
    .height = 320,
    .memory_width = 240,
    .memory_height = 320,
    .inverted = true,
};

const struct etch_lcd_panel etch_st7789_240x240 = {
    .controller = &etch_lcd_dcs,
    .init = init,
    .width = 240,
    .height = 240,
    .memory_width = 240,
    .memory_height = 320,
    .inverted = true,
};

const struct etch_lcd_panel etch_st7789_135x240 = {
    .controller = &etch_lcd_dcs,
    .init = init,
    .width = 135,
    .height = 240,
    .memory_width = 240,
    .memory_height = 320,
    .column = 52,
    .row = 40,
    .inverted = true,
};
