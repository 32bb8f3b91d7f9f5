/* ports/spi_lcd/dcs_rgb666.c: the same, but for those that take 18 bits a pixel on SPI. The panel
 * tables refer to it. */
#include "dcs.h"

const struct etch_lcd_controller etch_lcd_dcs_rgb666 = {ETCH_LCD_DCS, .brightness = 0x51,
                                                        .convert = etch_lcd_rgb666};
