/* frame/smooth_rows.h: the walk over a strip's pixels; no part of the API. */
#ifndef ETCH_FRAME_SMOOTH_ROWS_H
#define ETCH_FRAME_SMOOTH_ROWS_H

#include "pixel.h"
#include "smooth_pixel.h"

/* from + (to - from) numerator / denominator, rounded half up; the denominator is even. */
ETCH_INLINE uint32_t smooth_channel(uint32_t from, uint32_t to, struct smooth_blend b)
{
    const uint32_t rest = (uint32_t)(b.denominator - b.numerator);

    return (from * rest + to * b.numerator + b.denominator / 2U) / b.denominator;
}

ETCH_INLINE uint16_t smooth_mix(uint16_t from, uint16_t to, struct smooth_blend b)
{
    return pixel_pack(smooth_channel(from >> 11U, to >> 11U, b),
                      smooth_channel(from >> 5U & 63U, to >> 5U & 63U, b),
                      smooth_channel(from & 31U, to & 31U, b));
}

/* Step 1: whether the range of luma over the pixel and its four neighbours is great enough. */
ETCH_INLINE bool smooth_has_contrast(const uint16_t *const row[3], size_t left, size_t x,
                                     size_t right)
{
    const int16_t near[4] = {smooth_luma(row[0][x]), smooth_luma(row[2][x]),
                             smooth_luma(row[1][left]), smooth_luma(row[1][right])};
    int16_t least = smooth_luma(row[1][x]), most = least;

    for (uint8_t i = 0; i < 4; i++) {
        least = near[i] < least ? near[i] : least;
        most = near[i] > most ? near[i] : most;
    }
    return most - least >= (most / 8 > 24 ? most / 8 : 24);
}

ETCH_INLINE void smooth_walk(struct etch_carry *c, const struct etch_surface *source,
                             const struct etch_surface *strip, const bool swapped)
{
    const struct etch_rect area = etch_rect_intersect(strip->clip, c->frame);
    const size_t last = (size_t)(c->source.x1 - c->source.x0 - 1);
    struct smooth_place p = {c, source, 0, 0};

    for (p.y = area.y0; p.y < area.y1; p.y++) {
        const uint16_t *const row[3] = {etch_carry_row(c, source, p.y - 1),
                                        etch_carry_row(c, source, p.y),
                                        etch_carry_row(c, source, (int32_t)p.y + 1)};

        for (p.x = area.x0; p.x < area.x1; p.x++) {
            const size_t x = (size_t)(p.x - c->source.x0);
            uint16_t color = row[1][x];
            struct smooth_blend b = {0, 1, 0, 0};

            if (smooth_has_contrast(row, x == 0 ? 0 : x - 1, x, x == last ? last : x + 1))
                b = etch_smooth_find(&p);
            if (b.numerator != 0)
                color = smooth_mix(color, etch_smooth_color(&p, b.dx, b.dy), b);
            strip->pixels[etch_surface_index(strip, p.x, p.y)] = pixel_ordered(color, swapped);
        }
    }
    etch_carry_end(c, source);
}

#endif
