/* draw/triangle_small.h: triangles for programs that count bytes.
 *
 * The same calls as in triangle.h and shapes.h under other names, with the same contracts. They
 * cover the same pixels; flat colours are equal, interpolated values come from exact planes
 * (raster/plane_small.h) and keep the precise bounds, but a pixel's may round otherwise than the
 * fast call's. So draw all passes over one surface that must meet (depth LEQUAL, say) with one
 * set. Small and fast names may be mixed freely otherwise: any kernel goes with any painter of
 * its kind. What programs weigh and cost: `make size`, tests/bench/README.md.
 */
#ifndef ETCH_DRAW_TRIANGLE_SMALL_H
#define ETCH_DRAW_TRIANGLE_SMALL_H

#include "triangle.h"

/* etch_triangle_fill: vertices at the centres of the three pixels, one colour. */
void etch_triangle_fill_small(const struct etch_surface *s, int16_t x0, int16_t y0, int16_t x1,
                              int16_t y1, int16_t x2, int16_t y2, uint16_t color);

/* etch_triangle_flat, _gouraud and _gouraud_depth; kernels: etch_kernel_flat_small,
 * _gouraud_small and _gouraud_less_small (or the fast ones, or a user's). */
etch_triangle_painter etch_triangle_flat_small;
etch_triangle_painter etch_triangle_gouraud_small;
etch_triangle_painter etch_triangle_gouraud_depth_small;

#endif
