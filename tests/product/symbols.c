/* tests/product: the symbols of the menu. Strokes are two pixels wide. See symbols.h. */
#include "symbols.h"

enum {
    WIDE = 32 /* sixteenths */
};

static void stroke(const struct etch_surface *s, int16_t x0, int16_t y0, int16_t x1, int16_t y1,
                   struct ink ink)
{
    line(s, corner(x0, y0), corner(x1, y1), WIDE, ink);
}

/* A bulb: most of a circle, a neck, a socket. */
void symbol_lamp(const struct etch_surface *s, int16_t x, int16_t y, struct ink ink)
{
    arc(s, corner(x, (int16_t)(y - 2)), 8 * 16, 6 * 16, 32768 - 10923, 32768 + 2 * 10923, ink);
    stroke(s, (int16_t)(x - 3), (int16_t)(y + 4), (int16_t)(x - 3), (int16_t)(y + 6), ink);
    stroke(s, (int16_t)(x + 3), (int16_t)(y + 4), (int16_t)(x + 3), (int16_t)(y + 6), ink);
    stroke(s, (int16_t)(x - 3), (int16_t)(y + 7), (int16_t)(x + 3), (int16_t)(y + 7), ink);
    stroke(s, (int16_t)(x - 1), (int16_t)(y + 10), (int16_t)(x + 1), (int16_t)(y + 10), ink);
}

void symbol_thermometer(const struct etch_surface *s, int16_t x, int16_t y, struct ink ink)
{
    arc(s, corner(x, (int16_t)(y - 7)), 4 * 16, 2 * 16, 32768, 32768, ink);
    stroke(s, (int16_t)(x - 3), (int16_t)(y - 7), (int16_t)(x - 3), (int16_t)(y + 2), ink);
    stroke(s, (int16_t)(x + 3), (int16_t)(y - 7), (int16_t)(x + 3), (int16_t)(y + 2), ink);
    arc(s, corner(x, (int16_t)(y + 6)), 6 * 16, 4 * 16, 49152 + 5461, 65536 - 2 * 5461, ink);
    disc(s, corner(x, (int16_t)(y + 6)), 2 * 16 + 8, ink);
    stroke(s, x, (int16_t)(y - 2), x, (int16_t)(y + 5), ink);
}

void symbol_blinds(const struct etch_surface *s, int16_t x, int16_t y, struct ink ink)
{
    for (int16_t i = -8; i <= 4; i = (int16_t)(i + 4))
        stroke(s, (int16_t)(x - 8), (int16_t)(y + i), (int16_t)(x + 8), (int16_t)(y + i), ink);
    stroke(s, (int16_t)(x + 5), (int16_t)(y + 4), (int16_t)(x + 5), (int16_t)(y + 8), ink);
    disc(s, corner((int16_t)(x + 5), (int16_t)(y + 8)), 2 * 16, ink);
}

/* Two quavers under a beam. */
void symbol_note(const struct etch_surface *s, int16_t x, int16_t y, struct ink ink)
{
    const struct etch_point_q8 beam[] = {
        corner((int16_t)(x - 4), (int16_t)(y - 7)), corner((int16_t)(x + 8), (int16_t)(y - 9)),
        corner((int16_t)(x + 8), (int16_t)(y - 5)), corner((int16_t)(x - 4), (int16_t)(y - 3))};

    shape(s, beam, 4, ink);
    stroke(s, (int16_t)(x - 3), (int16_t)(y - 5), (int16_t)(x - 3), (int16_t)(y + 6), ink);
    stroke(s, (int16_t)(x + 7), (int16_t)(y - 7), (int16_t)(x + 7), (int16_t)(y + 4), ink);
    disc(s, corner((int16_t)(x - 5), (int16_t)(y + 6)), 3 * 16 + 4, ink);
    disc(s, corner((int16_t)(x + 5), (int16_t)(y + 4)), 3 * 16 + 4, ink);
}

/* A ring with eight teeth. */
void symbol_gear(const struct etch_surface *s, int16_t x, int16_t y, struct ink ink)
{
    ring(s, corner(x, y), 7 * 16, 4 * 16 + 8, ink);
    for (int i = 0; i < 8; i++) {
        const uint16_t angle = (uint16_t)(i * 8192 + 4096);
        struct etch_point_q8 a = polar(x, y, 6 * 16 + 8, angle), b = polar(x, y, 9 * 16, angle);

        a.x -= 128, a.y -= 128, b.x -= 128, b.y -= 128; /* the corner, not the middle of a pixel */
        line(s, a, b, 44, ink);
    }
}
