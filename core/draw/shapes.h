/* draw/shapes.h: 2D shapes in one colour, and clears. Every int16_t argument is legal: what is
 * off screen or empty draws what it covers. `color` is in the surface's byte order. Filled shapes
 * and clears write each pixel once. Lines, circles and rectangle outlines are in raster/. */
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

/* Its outline: three lines of raster/line.h, each corner once; where lines of a thin triangle run
 * together, pixels are written again. */
void etch_triangle_draw(const struct etch_surface *s, int16_t x0, int16_t y0, int16_t x1,
                        int16_t y1, int16_t x2, int16_t y2, uint16_t color);

/* Every pixel inside the clip becomes `color`. */
void etch_surface_clear(const struct etch_surface *s, uint16_t color);
/* Every depth inside the clip becomes `depth`, 65535 for "nothing drawn yet". The surface must
 * have a depth plane. */
void etch_depth_clear(const struct etch_surface *s, uint16_t depth);
/* Every stencil value inside the clip becomes `value`. The surface must have a stencil plane. */
void etch_stencil_clear(const struct etch_surface *s, uint8_t value);

#endif
