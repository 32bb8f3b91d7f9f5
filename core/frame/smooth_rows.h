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

ETCH_INLINE void smooth_walk(struct etch_carry *c, const struct etch_surface *source,
                             const struct etch_surface *strip, const bool swapped)
{
    const struct etch_rect area = etch_rect_intersect(strip->clip, c->frame);
    struct smooth_place p = {c, source, 0, 0};

    for (p.y = area.y0; p.y < area.y1; p.y++) {
        for (p.x = area.x0; p.x < area.x1; p.x++) {
            const struct smooth_blend b = etch_smooth_find(&p);
            uint16_t color = etch_smooth_color(&p, 0, 0);

            if (b.numerator != 0)
                color = smooth_mix(color, etch_smooth_color(&p, b.dx, b.dy), b);
            strip->pixels[etch_surface_index(strip, p.x, p.y)] = pixel_ordered(color, swapped);
        }
    }
    etch_carry_end(c, source);
}

#endif
