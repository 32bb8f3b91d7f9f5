/* ports/spi_lcd/send_rgb565.c: pixels as they lie in memory. lcd.c calls it through the
 * controller's table. */
#include "lcd.h"

int etch_lcd_send_rgb565(struct etch_lcd *lcd, struct etch_rect area, const uint16_t *pixels,
                         uint16_t stride)
{
    const uint16_t width = (uint16_t)(area.x1 - area.x0);
    const uint16_t height = (uint16_t)(area.y1 - area.y0);
    const bool adjacent = stride == width;
    const uint32_t part = etch_mul_u16(width, adjacent ? height : 1) * 2;
    uint16_t rows = adjacent ? 1 : height;
    int status = etch_lcd_data(lcd, (const uint8_t *)pixels, part);

    while (status >= 0 && --rows != 0) {
        pixels += stride;
        status = lcd->bus->wait(lcd->bus);
        if (status >= 0) {
            status = etch_lcd_data(lcd, (const uint8_t *)pixels, part);
        }
    }
    return status;
}
