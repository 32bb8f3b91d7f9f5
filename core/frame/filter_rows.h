/* frame/filter_rows.h: the walk that the 3 x 3 filters share; no part of the API. */
#ifndef ETCH_FRAME_FILTER_ROWS_H
#define ETCH_FRAME_FILTER_ROWS_H

#include "filter.h"
#include "pixel.h"

/* Three rows of the source, and the columns left of, at and right of a pixel, held to the frame. */
struct filter_place {
    const uint16_t *row[3];
    size_t column[3];
};

typedef uint16_t filter_pixel(const struct filter_place *p, const void *data);

/* What the surface's clip and window leave of a strip. */
ETCH_INLINE void filter_walk(struct etch_carry *c, const struct etch_surface *source,
                             const struct etch_surface *strip, const void *data,
                             filter_pixel *pixel, const bool swapped)
{
    const struct etch_rect area = etch_rect_intersect(strip->clip, c->frame);
    const size_t last = (size_t)(c->source.x1 - c->source.x0 - 1);

    for (int16_t y = area.y0; y < area.y1; y++) {
        struct filter_place p;

        for (uint8_t i = 0; i < 3; i++)
            p.row[i] = etch_carry_row(c, source, (int32_t)y + i - 1);
        for (int16_t x = area.x0; x < area.x1; x++) {
            const size_t at = (size_t)(x - c->source.x0);

            p.column[0] = at == 0 ? 0 : at - 1;
            p.column[1] = at;
            p.column[2] = at == last ? last : at + 1;
            strip->pixels[etch_surface_index(strip, x, y)] = pixel_ordered(pixel(&p, data),
                                                                           swapped);
        }
    }
    etch_carry_end(c, source);
}

#endif
