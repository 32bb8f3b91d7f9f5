/* ports/spi_lcd/send_gray4.c: 16 grey levels, two pixels a byte. lcd.c calls it through the
 * controller's table. The two share a memory row, so they are neighbours along the frame's x, or
 * along its y if it is turned. */
#include "dither.h"

int etch_lcd_send_gray4(struct etch_lcd *lcd, struct etch_rect area, const uint16_t *pixels,
                        uint16_t stride)
{
    const bool swap = (lcd->orientation & ETCH_LCD_SWAP) != 0;
    const int16_t dx = swap ? 0 : 1, dy = swap ? 1 : 0;
    const uint16_t next = swap ? stride : 1;
    struct etch_lcd_stream s = etch_lcd_stream_begin(lcd, 1);

    for (int16_t y = area.y0; y < area.y1 && s.status >= 0; y = (int16_t)(y + 1 + dy)) {
        const uint16_t *p = pixels;

        for (int16_t x = area.x0; x < area.x1; x = (int16_t)(x + 1 + dx), p += 1 + dx) {
            const uint8_t first = etch_lcd_gray(p[0], x, y, 15);
            const uint8_t second = etch_lcd_gray(p[next], (int16_t)(x + dx), (int16_t)(y + dy), 15);

            etch_lcd_stream_put(&s, (uint8_t)(first << 4 | second));
        }
        pixels += (size_t)stride << dy;
    }
    return etch_lcd_stream_end(&s);
}
