/* ports/spi_lcd/stream.h: converted pixels on their way to the bus, through the two halves of
 * the scratch buffer: one is filled while the other is sent. The senders that convert use it. */
#ifndef ETCH_PORTS_SPI_LCD_STREAM_H
#define ETCH_PORTS_SPI_LCD_STREAM_H

#include "lcd.h"

struct etch_lcd_stream {
    struct etch_lcd *lcd;
    uint8_t *begin, *at, *end; /* of the half that is filled */
    bool sending;              /* the other half */
    int status;                /* after an error nothing more is sent */
};

/* Begins, in the lower half; a half holds a multiple of `unit` bytes, unit <= 3. */
struct etch_lcd_stream etch_lcd_stream_begin(struct etch_lcd *lcd, uint8_t unit);

/* Sends the half that was filled and goes on with the other. */
void etch_lcd_stream_turn(struct etch_lcd_stream *s);

/* Sends what is left; the transfer may be under way on return. The first error, or 0. */
int etch_lcd_stream_end(struct etch_lcd_stream *s);

ETCH_INLINE void etch_lcd_stream_put(struct etch_lcd_stream *s, uint8_t byte)
{
    *s->at++ = byte;
    if (s->at == s->end) {
        etch_lcd_stream_turn(s);
    }
}

/* A pixel of the buffer as 0brrrrrggggggbbbbb. */
ETCH_INLINE uint16_t etch_lcd_color(uint16_t pixel)
{
    return ETCH_FORMAT_HIGH_BYTE_FIRST == ETCH_FORMAT_RGB565 ? pixel : etch_rgb565_swap(pixel);
}

#endif
