/* ports/spi_lcd/lcd_pixels.c: the pixels of a strip as pieces for the bus, which asks for them,
 * often in an interrupt. lcd.c begins with it. See lcd.h. */
#include "lcd.h"

/* As they lie in memory: all rows in one piece if they are adjacent, else one a row, and as many
 * more as the bus's limit makes of them. */
static const uint8_t *next_plain(struct etch_pieces *pieces, uint32_t *n)
{
    struct etch_lcd_pixels *s = (struct etch_lcd_pixels *)pieces;
    const uint32_t limit = s->lcd->bus->limit;
    const uint8_t *bytes;

    if (s->left == 0) {
        if (s->y >= s->area.y1) {
            return NULL;
        }
        s->at = (const uint8_t *)etch_lcd_row(s);
        s->left = s->part;
        s->y = (int16_t)(s->y + s->rows);
    }
    bytes = s->at;
    *n = limit != 0 && s->left > limit ? limit : s->left;
    s->at += *n;
    s->left -= *n;
    return bytes;
}

/* Converted into one half of the scratch buffer, while the other is sent. */
static const uint8_t *next_converted(struct etch_pieces *pieces, uint32_t *n)
{
    struct etch_lcd_pixels *s = (struct etch_lcd_pixels *)pieces;
    const struct etch_lcd *lcd = s->lcd;
    const uint16_t half = lcd->setup.scratch_size / 2;
    const uint16_t room = lcd->bus->limit != 0 && half > lcd->bus->limit ? (uint16_t)lcd->bus->limit
                                                                         : half;
    uint8_t *const to = lcd->setup.scratch + (s->upper ? half : 0);

    s->upper = !s->upper;
    *n = lcd->panel->controller->convert(s, to, room);
    return *n != 0 ? to : NULL;
}

struct etch_pieces *etch_lcd_pixels(struct etch_lcd *lcd, struct etch_rect area,
                                    const uint16_t *pixels, uint16_t stride)
{
    const uint16_t width = (uint16_t)(area.x1 - area.x0);
    const bool adjacent = stride == width;
    struct etch_lcd_pixels *s = &lcd->pixels;

    *s = (struct etch_lcd_pixels){
        .lcd = lcd, .area = area, .pixels = pixels, .stride = stride, .x = area.x0, .y = area.y0};
    s->rows = adjacent ? (int16_t)(area.y1 - area.y0) : 1;
    s->part = etch_mul_u16(width, (uint16_t)s->rows) * 2;
    s->pieces.next = lcd->panel->controller->convert != NULL ? next_converted : next_plain;
    return &s->pieces;
}
