/* draw/shapes_small.h: rectangles, discs and circles for programs that count bytes.
 *
 * The pixels of the calls of the same names in shapes.h and raster/circle.h, clipped as exactly,
 * each once; a few times slower: 6 instructions a pixel on ARMv6-M, and a square root a row of a
 * disc, two of a circle. A rectangle over the frame clears it. What programs weigh: `make size`.
 */
#ifndef ETCH_DRAW_SHAPES_SMALL_H
#define ETCH_DRAW_SHAPES_SMALL_H

#include "../base/surface.h"

void etch_rect_fill_small(const struct etch_surface *s, int16_t x, int16_t y, int16_t w, int16_t h,
                          uint16_t color);
void etch_circle_fill_small(const struct etch_surface *s, int16_t cx, int16_t cy, int16_t r,
                            uint16_t color);
void etch_circle_draw_small(const struct etch_surface *s, int16_t cx, int16_t cy, int16_t r,
                            uint16_t color);

/* The part of pixels x0 .. x1 - 1 of row y, a row of the clip, that is inside the clip. */
void etch_span_fill_small(const struct etch_surface *s, int32_t y, int32_t x0, int32_t x1,
                          uint16_t color);

#endif
