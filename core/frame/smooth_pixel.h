/* frame/smooth_pixel.h: finding and following the edge at a pixel; no part of the API. */
#ifndef ETCH_FRAME_SMOOTH_PIXEL_H
#define ETCH_FRAME_SMOOTH_PIXEL_H

#include "smooth.h"

/* A picture, a pixel of it, and the columns at hand. */
struct smooth_place {
    const struct etch_carry *carry;
    const struct etch_surface *source;
    int16_t x, y;
};

/* The edge at a pixel. */
struct smooth_edge {
    bool along_row;
    int8_t side;       /* -1 up or left, +1 down or right */
    int16_t sum, step; /* luma of both rows of the edge, and the side's less the pixel's */
};

/* How much of the side's colour goes to the pixel: numerator / denominator, 0 .. 1/2. */
struct smooth_blend {
    uint8_t numerator, denominator;
    int8_t dx, dy; /* where the side is */
};

/* The colour dx, dy beside the place, the nearest of the frame. */
uint16_t etch_smooth_color(const struct smooth_place *p, int32_t dx, int32_t dy);

/* 0 .. 532. */
ETCH_INLINE int16_t smooth_luma(uint16_t color)
{
    return (int16_t)(5 * ((color >> 11) + (color >> 5 & 63)) + 2 * (color & 31));
}

/* Numerator 0: the pixel stays. For pixels that have contrast. */
struct smooth_blend etch_smooth_find(const struct smooth_place *p);

#endif
