/* ports/spi_lcd/convert_gray4.c: 16 grey levels, two pixels a byte. lcd_pixels.c calls it through
 * the controller's table. The two share a memory row, so they are neighbours along the frame's x,
 * or along its y if it is turned. */
#include "dither.h"

uint16_t etch_lcd_gray4(struct etch_lcd_pixels *s, uint8_t *to, uint16_t room)
{
    const bool swap = (s->lcd->orientation & ETCH_LCD_SWAP) != 0;
    const int16_t dx = swap ? 0 : 1, dy = swap ? 1 : 0;
    const uint16_t next = swap ? s->stride : 1;
    uint16_t n = 0;

    for (; n < room && s->y < s->area.y1; n++) {
        const uint16_t *p = etch_lcd_row(s) + (s->x - s->area.x0);
        const uint8_t first = etch_lcd_gray(p[0], s->x, s->y, 15);
        const uint8_t second = etch_lcd_gray(p[next], (int16_t)(s->x + dx), (int16_t)(s->y + dy),
                                             15);

        to[n] = (uint8_t)(first << 4 | second);
        etch_lcd_advance(s, (int16_t)(1 + dx), (int16_t)(1 + dy));
    }
    return n;
}
