/* ports/spi_lcd/stream.c: the scratch buffer in two halves. The senders that convert call it. */
#include "stream.h"

struct etch_lcd_stream etch_lcd_stream_begin(struct etch_lcd *lcd, uint8_t unit)
{
    const uint16_t half = (uint16_t)(lcd->setup.scratch_size / 2 / unit * unit);
    const struct etch_lcd_stream s = {.lcd = lcd,
                                      .begin = lcd->setup.scratch,
                                      .at = lcd->setup.scratch,
                                      .end = lcd->setup.scratch + half};
    return s;
}

/* Waits for the other half. */
static void settle(struct etch_lcd_stream *s)
{
    const struct etch_bus *bus = s->lcd->bus;

    if (s->sending) {
        s->sending = false;
        s->status = bus->wait(bus);
    }
}

void etch_lcd_stream_turn(struct etch_lcd_stream *s)
{
    const ptrdiff_t half = s->end - s->begin;
    uint8_t *const lower = s->lcd->setup.scratch;

    settle(s);
    if (s->status >= 0) {
        s->status = etch_lcd_data(s->lcd, s->begin, (uint32_t)(s->at - s->begin));
        s->sending = s->status >= 0;
    }
    s->begin = s->begin == lower ? lower + half : lower;
    s->at = s->begin;
    s->end = s->begin + half;
}

int etch_lcd_stream_end(struct etch_lcd_stream *s)
{
    if (s->at != s->begin) {
        etch_lcd_stream_turn(s);
    }
    return s->status;
}
