/* ports/spi_lcd/send_rgb666.c: three bytes a pixel, for controllers that take no RGB565 on SPI.
 * lcd.c calls it through the controller's table. */
#include "stream.h"

int etch_lcd_send_rgb666(struct etch_lcd *lcd, struct etch_rect area, const uint16_t *pixels,
                         uint16_t stride)
{
    const uint16_t width = (uint16_t)(area.x1 - area.x0);
    struct etch_lcd_stream s = etch_lcd_stream_begin(lcd, 3);

    for (int16_t y = area.y0; y < area.y1 && s.status >= 0; y++, pixels += stride) {
        for (uint16_t x = 0; x < width; x++) {
            const uint16_t color = etch_lcd_color(pixels[x]);

            /* The 8-bit channels' upper 6 bits are those of the 6-bit ones. */
            etch_lcd_stream_put(&s, etch_rgb565_red(color) & 0xFC);
            etch_lcd_stream_put(&s, etch_rgb565_green(color) & 0xFC);
            etch_lcd_stream_put(&s, etch_rgb565_blue(color) & 0xFC);
        }
    }
    return etch_lcd_stream_end(&s);
}
