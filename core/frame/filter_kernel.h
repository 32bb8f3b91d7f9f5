/* frame/filter_kernel.h: one pixel of each filter; no part of the API. */
#ifndef ETCH_FRAME_FILTER_KERNEL_H
#define ETCH_FRAME_FILTER_KERNEL_H

#include "filter_rows.h"

/* ---- any kernel ------------------------------------------------------------------------- */

struct filter_scale {
    const int8_t *weight;
    struct pixel_divisor divisor;
    int32_t add, add_green; /* bias in steps, times the divisor, and half of it */
};

/* floor((bias most + 127) / 255): 255 is odd, so this is the nearest. */
ETCH_INLINE int32_t filter_bias(int16_t bias, int32_t most)
{
    const int32_t n = bias * most + 127;

    return n >= 0 ? n / 255 : -((254 - n) / 255);
}

ETCH_INLINE struct filter_scale filter_scale(const struct etch_filter_weights *w)
{
    const uint8_t d = w->divisor == 0 ? 1 : w->divisor;
    const struct filter_scale s = {w->weight, pixel_divisor(d),
                                   filter_bias(w->bias, 31) * d + d / 2,
                                   filter_bias(w->bias, 63) * d + d / 2};

    return s;
}

/* |sum| <= 9 * 128 * 63 < 2^17, |add| <= 63 * 255 + 127 < 2^14. */
ETCH_INLINE uint16_t filter_any(const struct filter_place *p, const void *data)
{
    const struct filter_scale *s = data;
    int32_t r = s->add, g = s->add_green, b = s->add;

    ETCH_UNROLL(9)
    for (uint8_t i = 0; i < 9; i++) {
        const uint16_t color = p->row[i / 3][p->column[i % 3]];
        const int32_t w = s->weight[i];

        r += w * (color >> 11);
        g += w * (color >> 5 & 63);
        b += w * (color & 31);
    }
    return pixel_pack(pixel_divide(r, s->divisor, 31), pixel_divide(g, s->divisor, 63),
                      pixel_divide(b, s->divisor, 31));
}

/* ---- average ---------------------------------------------------------------------------- */

/* As supersample_rows.h: nine have no ties, v * 7282 >> 16 = v / 9. */
ETCH_INLINE uint16_t filter_nine(const struct filter_place *p, const void *data)
{
    uint32_t sum = 4 * PIXEL_ONES;

    (void)data;
    ETCH_UNROLL(3)
    for (uint8_t i = 0; i < 3; i++)
        sum += pixel_spread(p->row[i][p->column[0]]) + pixel_spread(p->row[i][p->column[1]]) +
               pixel_spread(p->row[i][p->column[2]]);
    return pixel_pack(pixel_red(sum) * 7282 >> 16, pixel_green(sum) * 7282 >> 16,
                      pixel_blue(sum) * 7282 >> 16);
}

/* ---- Sobel ------------------------------------------------------------------------------ */

/* The sum 1 2 1 of three spread pixels: at most 4 * 63 in a channel. */
ETCH_INLINE uint32_t filter_121(uint16_t a, uint16_t b, uint16_t c)
{
    return pixel_spread(a) + 2 * pixel_spread(b) + pixel_spread(c);
}

ETCH_INLINE uint32_t filter_apart(uint32_t a, uint32_t b)
{
    return a > b ? a - b : b - a;
}

ETCH_INLINE uint32_t filter_quarter(uint32_t sum, uint32_t most)
{
    return (sum + 2) / 4 < most ? (sum + 2) / 4 : most;
}

ETCH_INLINE uint16_t filter_edges(const struct filter_place *p, const void *data)
{
    const size_t *c = p->column;
    const uint16_t *const *r = p->row;
    const uint32_t left = filter_121(r[0][c[0]], r[1][c[0]], r[2][c[0]]);
    const uint32_t right = filter_121(r[0][c[2]], r[1][c[2]], r[2][c[2]]);
    const uint32_t up = filter_121(r[0][c[0]], r[0][c[1]], r[0][c[2]]);
    const uint32_t down = filter_121(r[2][c[0]], r[2][c[1]], r[2][c[2]]);

    (void)data;
    return pixel_pack(filter_quarter(filter_apart(pixel_red(left), pixel_red(right)) +
                                         filter_apart(pixel_red(up), pixel_red(down)),
                                     31),
                      filter_quarter(filter_apart(pixel_green(left), pixel_green(right)) +
                                         filter_apart(pixel_green(up), pixel_green(down)),
                                     63),
                      filter_quarter(filter_apart(pixel_blue(left), pixel_blue(right)) +
                                         filter_apart(pixel_blue(up), pixel_blue(down)),
                                     31));
}

#endif
