/* ports/spi_lcd/dcs.c: controllers that know the shared commands, brightness included, and take
 * RGB565. The panel tables refer to it. */
#include "dcs.h"

const struct etch_lcd_controller etch_lcd_dcs = {ETCH_LCD_DCS, .brightness = 0x51};
