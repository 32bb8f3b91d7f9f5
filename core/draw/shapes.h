/* draw/shapes.h: filled 2D shapes in one colour (outlines are in raster/). Every int16_t
 * argument is legal: what is off screen or empty draws what it covers. `color` is in the
 * surface's byte order. Each pixel is written once. */
#ifndef ETCH_DRAW_SHAPES_H
#define ETCH_DRAW_SHAPES_H

#include "../base/surface.h"

/* The rectangle (x, y, w, h); w or h <= 0 draws nothing. */
void etch_rect_fill(const struct etch_surface *s, int16_t x, int16_t y, int16_t w, int16_t h,
                    uint16_t color);

/* The disc of radius r round pixel (cx, cy); r < 0 draws nothing. */
void etch_circle_fill(const struct etch_surface *s, int16_t cx, int16_t cy, int16_t r,
                      uint16_t color);

/* The triangle whose vertices are at the centres of the three pixels. */
void etch_triangle_fill(const struct etch_surface *s, int16_t x0, int16_t y0, int16_t x1,
                        int16_t y1, int16_t x2, int16_t y2, uint16_t color);

/* Its outline: three lines, each corner once. */
void etch_triangle_draw(const struct etch_surface *s, int16_t x0, int16_t y0, int16_t x1,
                        int16_t y1, int16_t x2, int16_t y2, uint16_t color);

/* The colour plane, and the depth plane, through the clip: every pixel becomes the value.
 * etch_depth_clear needs a depth plane. */
void etch_surface_clear(const struct etch_surface *s, uint16_t color);
void etch_depth_clear(const struct etch_surface *s, uint16_t depth);

#endif
