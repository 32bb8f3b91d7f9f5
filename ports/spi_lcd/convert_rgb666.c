/* ports/spi_lcd/convert_rgb666.c: three bytes a pixel, for controllers that take no RGB565 on SPI.
 * lcd_pixels.c calls it through the controller's table. */
#include "lcd.h"

/* left / 3 for left < 32768: 21846 is a third of 65536 and 2/3 of a unit more, which adds less than
 * a third. */
static uint16_t third(uint16_t left)
{
    return (uint16_t)(etch_mul_u16(left, 21846) >> 16);
}

uint16_t etch_lcd_rgb666(struct etch_lcd_pixels *s, uint8_t *to, uint16_t room)
{
    uint16_t left = room;

    while (left >= 3 && s->y < s->area.y1) {
        const uint16_t *from = etch_lcd_row(s) + (s->x - s->area.x0);
        const uint16_t in_row = (uint16_t)(s->area.x1 - s->x), fit = third(left);
        const uint16_t count = in_row < fit ? in_row : fit;

        /* 19 instructions a pixel on Cortex-M0+; the lower two bits of a byte are not looked at */
        for (const uint16_t *end = from + count; from != end; from++, to += 3) {
            const unsigned color = etch_lcd_color(*from);

            to[0] = (uint8_t)((color >> 8 & 0xF8) | color >> 13);
            to[1] = (uint8_t)(color >> 3 & 0xFF);
            to[2] = (uint8_t)((color & 0x1F) << 3 | (color >> 2 & 7));
        }
        left = (uint16_t)(left - 3 * count);
        etch_lcd_advance(s, (int16_t)count, 1);
    }
    return (uint16_t)(room - left);
}
