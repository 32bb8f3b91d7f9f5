/* ports/spi_lcd/panels.h: the panels there are. A program links those it names. */
#ifndef ETCH_PORTS_SPI_LCD_PANELS_H
#define ETCH_PORTS_SPI_LCD_PANELS_H

#include "lcd.h"

/* ili9341.c */
extern const struct etch_lcd_panel etch_ili9341; /* 240 x 320 */

/* st7789.c: IPS glasses */
extern const struct etch_lcd_panel etch_st7789;         /* 240 x 320 */
extern const struct etch_lcd_panel etch_st7789_240x240; /* 1.3" and 1.54" */
extern const struct etch_lcd_panel etch_st7789_135x240; /* 1.14" */

/* st7735.c: named by the colour of the tab on the foil, as modules are sold. */
extern const struct etch_lcd_panel etch_st7735_black;   /* 128 x 160 */
extern const struct etch_lcd_panel etch_st7735_red;     /* 128 x 160, blue filter first */
extern const struct etch_lcd_panel etch_st7735_green;   /* 128 x 160, two columns and a row off */
extern const struct etch_lcd_panel etch_st7735_128x128; /* 1.44" */
extern const struct etch_lcd_panel etch_st7735_80x160;  /* 0.96", IPS */

/* gc9a01.c: round, 1.28" */
extern const struct etch_lcd_panel etch_gc9a01; /* 240 x 240 */

/* ili9488.c: takes 18 bits a pixel on SPI; needs a scratch buffer */
extern const struct etch_lcd_panel etch_ili9488; /* 320 x 480 */

/* st7796.c */
extern const struct etch_lcd_panel etch_st7796; /* 320 x 480 */

/* ssd1351.c: colour OLED */
extern const struct etch_lcd_panel etch_ssd1351; /* 128 x 128 */

/* ssd1306.c: black-and-white OLED; needs a scratch buffer */
extern const struct etch_lcd_panel etch_ssd1306;        /* 128 x 64 */
extern const struct etch_lcd_panel etch_ssd1306_128x32; /* 128 x 32 */

/* ssd0323.c: OLED with 16 grey levels; needs a scratch buffer */
extern const struct etch_lcd_panel etch_ssd0323; /* 128 x 64 */

/* Controllers: the commands that the MIPI display command set gives most of them. */
extern const struct etch_lcd_controller etch_lcd_dcs;        /* dcs.c: RGB565 */
extern const struct etch_lcd_controller etch_lcd_dcs_rgb666; /* dcs_rgb666.c: 18 bits a pixel;
                                                                needs a scratch buffer */

#endif
