/* draw/image_parts.h: what drawing images by whole texels shares; no part of the API. */
#ifndef ETCH_DRAW_IMAGE_PARTS_H
#define ETCH_DRAW_IMAGE_PARTS_H

#include "image.h"

/* A rectangle of the frame and the place of the texel at its upper left pixel; dx and dy lead to
 * the texels of the next pixel and row, modulo 2^32. x, y, w and h together fit 32 bits. */
struct etch_image_area {
    int32_t x, y, w, h;
    uint32_t place, dx, dy;
};

/* Draws what is inside the clip. */
void etch_image_area_draw(const struct etch_surface *s, const struct etch_image_style *style,
                          const struct etch_image_area *area);

#endif
