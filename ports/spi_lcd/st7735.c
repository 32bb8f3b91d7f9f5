/* ports/spi_lcd/st7735.c: ST7735R and ST7735S. Tables for lcd.c. Their memory is 132 x 162, 132 x
 * 132 or 128 x 160, as three pins of the chip say. Values as Adafruit's driver and
 * TFT_eSPI both set them; frame rate, power and gamma vary by module. */
#include "dcs.h"

/* clang-format off */
static const uint8_t init[] = {
    ETCH_LCD_DELAY, 0x01, 150,                   /* software reset */
    ETCH_LCD_DELAY, 0x11, 120,                   /* wake up */
    3, 0xB1, 0x01, 0x2C, 0x2D,                   /* frame rate: normal, */
    3, 0xB2, 0x01, 0x2C, 0x2D,                   /* idle */
    6, 0xB3, 0x01, 0x2C, 0x2D, 0x01, 0x2C, 0x2D, /* and partial mode */
    1, 0xB4, 0x07,                               /* no line inversion */
    3, 0xC0, 0xA2, 0x02, 0x84,                   /* GVDD -4.6 V */
    1, 0xC1, 0xC5,                               /* gate voltages */
    2, 0xC2, 0x0A, 0x00,                         /* supply currents: normal, */
    2, 0xC3, 0x8A, 0x2A,                         /* idle */
    2, 0xC4, 0x8A, 0xEE,                         /* and partial mode */
    1, 0xC5, 0x0E,                               /* VCOM -0.775 V */
    1, 0x3A, 0x05,                               /* 16 bits a pixel */
    /* gamma, positive and negative */
    16, 0xE0, 0x02, 0x1C, 0x07, 0x12, 0x37, 0x32, 0x29, 0x2D, 0x29, 0x25, 0x2B, 0x39, 0x00, 0x01,
        0x03, 0x10,
    16, 0xE1, 0x03, 0x1D, 0x07, 0x06, 0x2E, 0x2C, 0x29, 0x2D, 0x2E, 0x2E, 0x37, 0x3F, 0x00, 0x00,
        0x02, 0x10,
    ETCH_LCD_DELAY, 0x13, 10,                    /* normal mode */
    ETCH_LCD_END,
};
/* clang-format on */

/* Every command of the set, but brightness. */
static const struct etch_lcd_controller st7735 = {ETCH_LCD_DCS};

const struct etch_lcd_panel etch_st7735_black = {
    .controller = &st7735,
    .init = init,
    .width = 128,
    .height = 160,
    .memory_width = 128,
    .memory_height = 160,
    .mount = ETCH_LCD_FLIP_COLUMNS | ETCH_LCD_FLIP_ROWS,
};

const struct etch_lcd_panel etch_st7735_red = {
    .controller = &st7735,
    .init = init,
    .width = 128,
    .height = 160,
    .memory_width = 128,
    .memory_height = 160,
    .mount = ETCH_LCD_FLIP_COLUMNS | ETCH_LCD_FLIP_ROWS,
    .bgr = true,
};

const struct etch_lcd_panel etch_st7735_green = {
    .controller = &st7735,
    .init = init,
    .width = 128,
    .height = 160,
    .memory_width = 132,
    .memory_height = 162,
    .column = 2,
    .row = 1,
    .mount = ETCH_LCD_FLIP_COLUMNS | ETCH_LCD_FLIP_ROWS,
    .bgr = true,
};

const struct etch_lcd_panel etch_st7735_128x128 = {
    .controller = &st7735,
    .init = init,
    .width = 128,
    .height = 128,
    .memory_width = 132,
    .memory_height = 132,
    .column = 2,
    .row = 1,
    .mount = ETCH_LCD_FLIP_COLUMNS | ETCH_LCD_FLIP_ROWS,
    .bgr = true,
};

const struct etch_lcd_panel etch_st7735_80x160 = {
    .controller = &st7735,
    .init = init,
    .width = 80,
    .height = 160,
    .memory_width = 132,
    .memory_height = 162,
    .column = 26,
    .row = 1,
    .mount = ETCH_LCD_FLIP_COLUMNS | ETCH_LCD_FLIP_ROWS,
    .bgr = true,
    .inverted = true,
};
