/* draw/round.h: ellipses, rounded rectangles, rings, arcs and pies in one colour.
 *
 * Which pixels: raster/ellipse.h, round_rect.h and arc.h, whose .._runs give the same shapes to any
 * paint. Every int16_t is legal: what is off screen or empty draws what it covers. Each pixel is
 * written once. `color` is in the surface's byte order. Angles are in 65536ths of a turn, clockwise
 * from the right; a sweep of 0 draws nothing and one of 65536 or more a full turn.
 */
#ifndef ETCH_DRAW_ROUND_H
#define ETCH_DRAW_ROUND_H

#include "../base/surface.h"

/* The ellipse of radii rx, ry round pixel (cx, cy), and its outline. */
void etch_ellipse_fill(const struct etch_surface *s, int16_t cx, int16_t cy, int16_t rx, int16_t ry,
                       uint16_t color);
void etch_ellipse_draw(const struct etch_surface *s, int16_t cx, int16_t cy, int16_t rx, int16_t ry,
                       uint16_t color);

/* The rectangle (x, y, w, h) with corners of radius r, at most (min(w, h) - 1) / 2. */
void etch_round_rect_fill(const struct etch_surface *s, int16_t x, int16_t y, int16_t w, int16_t h,
                          int16_t r, uint16_t color);
void etch_round_rect_draw(const struct etch_surface *s, int16_t x, int16_t y, int16_t w, int16_t h,
                          int16_t r, uint16_t color);

/* The disc of radius `outer` less the disc of radius `inner`; its two borders. */
void etch_ring_fill(const struct etch_surface *s, int16_t cx, int16_t cy, int16_t outer,
                    int16_t inner, uint16_t color);
void etch_ring_draw(const struct etch_surface *s, int16_t cx, int16_t cy, int16_t outer,
                    int16_t inner, uint16_t color);

/* The circle of radius r from the angle `from` on; and a thick arc, part of a ring. */
void etch_arc_draw(const struct etch_surface *s, int16_t cx, int16_t cy, int16_t r, uint16_t from,
                   uint32_t sweep, uint16_t color);
void etch_arc_fill(const struct etch_surface *s, int16_t cx, int16_t cy, int16_t outer,
                   int16_t inner, uint16_t from, uint32_t sweep, uint16_t color);

/* The part of the disc of radius r, and its border: an arc and two radii. */
void etch_pie_fill(const struct etch_surface *s, int16_t cx, int16_t cy, int16_t r, uint16_t from,
                   uint32_t sweep, uint16_t color);
void etch_pie_draw(const struct etch_surface *s, int16_t cx, int16_t cy, int16_t r, uint16_t from,
                   uint32_t sweep, uint16_t color);

#endif
