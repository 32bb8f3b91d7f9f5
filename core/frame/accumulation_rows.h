/* frame/accumulation_rows.h: walking plane and surface together; no part of the API. */
#ifndef ETCH_FRAME_ACCUMULATION_ROWS_H
#define ETCH_FRAME_ACCUMULATION_ROWS_H

#include "accumulation.h"
#include "pixel.h"

/* The sums of pixel (x, y), which lies in the plane's window. */
ETCH_INLINE uint16_t *accumulation_at(const struct etch_accumulation *a, int16_t x, int16_t y)
{
    const size_t index = (size_t)(y - a->window.y0) * a->stride + (size_t)(x - a->window.x0);

    return a->sums + 3 * index;
}

/* What is done to the sums of a pixel, with the caller's number. */
typedef void accumulation_step(uint16_t *sums, const uint16_t *pixel, uint32_t number);

ETCH_INLINE void accumulation_walk(const struct etch_accumulation *a, const struct etch_surface *s,
                                   uint32_t number, accumulation_step *step)
{
    const struct etch_rect area = etch_rect_intersect(a->window, s->clip);

    if (etch_rect_is_empty(area))
        return;
    for (int16_t y = area.y0; y < area.y1; y++) {
        uint16_t *pixel = s->pixels + etch_surface_index(s, area.x0, y);
        uint16_t *const end = pixel + (area.x1 - area.x0);

        for (uint16_t *sums = accumulation_at(a, area.x0, y); pixel != end; pixel++, sums += 3)
            step(sums, pixel, number);
    }
}

/* 65535 if it is more. */
ETCH_INLINE uint16_t accumulation_held(uint32_t sum)
{
    return (uint16_t)(sum < UINT16_MAX ? sum : UINT16_MAX);
}

#endif
