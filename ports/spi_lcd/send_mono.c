/* ports/spi_lcd/send_mono.c: black and white, 8 pixels a byte. lcd.c calls it through the
 * controller's table. A byte is a stack of 8 memory rows: 8 frame rows, or 8 pixels of a frame
 * row if it is turned; then the bytes go along that row, as the addressing mode is set. */
#include "dither.h"

int etch_lcd_send_mono(struct etch_lcd *lcd, struct etch_rect area, const uint16_t *pixels,
                       uint16_t stride)
{
    const bool swap = (lcd->orientation & ETCH_LCD_SWAP) != 0;
    const int16_t dx = swap ? 1 : 0, dy = swap ? 0 : 1;
    const uint16_t next = swap ? 1 : stride;
    struct etch_lcd_stream s = etch_lcd_stream_begin(lcd, 1);

    for (int16_t y = area.y0; y < area.y1 && s.status >= 0; y = (int16_t)(y + 1 + 7 * dy)) {
        const uint16_t *p = pixels;

        for (int16_t x = area.x0; x < area.x1; x = (int16_t)(x + 1 + 7 * dx), p += 1 + 7 * dx) {
            unsigned byte = 0;

            for (int16_t i = 0; i < 8; i++) {
                const uint16_t pixel = p[(size_t)i * next];
                const int16_t px = (int16_t)(x + i * dx), py = (int16_t)(y + i * dy);

                byte |= (unsigned)etch_lcd_gray(pixel, px, py, 1) << i;
            }
            etch_lcd_stream_put(&s, (uint8_t)byte);
        }
        pixels += (size_t)stride << (3 * dy);
    }
    return etch_lcd_stream_end(&s);
}
