/* ports/spi_lcd/convert_mono.c: black and white, 8 pixels a byte. lcd_pixels.c calls it through the
 * controller's table. A byte is a stack of 8 memory rows: 8 frame rows, or 8 pixels of a frame
 * row if it is turned; then the bytes go along that row, as the addressing mode is set. */
#include "dither.h"

uint16_t etch_lcd_mono(struct etch_lcd_pixels *s, uint8_t *to, uint16_t room)
{
    const bool swap = (s->lcd->orientation & ETCH_LCD_SWAP) != 0;
    const int16_t dx = swap ? 1 : 0, dy = swap ? 0 : 1;
    const uint16_t next = swap ? 1 : s->stride;
    uint16_t n = 0;

    for (; n < room && s->y < s->area.y1; n++) {
        const uint16_t *p = etch_lcd_row(s) + (s->x - s->area.x0);
        unsigned byte = 0;

        for (int16_t i = 0; i < 8; i++, p += next) {
            const int16_t x = (int16_t)(s->x + i * dx), y = (int16_t)(s->y + i * dy);

            byte |= (unsigned)etch_lcd_gray(*p, x, y, 1) << i;
        }
        to[n] = (uint8_t)byte;
        etch_lcd_advance(s, (int16_t)(1 + 7 * dx), (int16_t)(1 + 7 * dy));
    }
    return n;
}
