/* draw/exact.h: triangles whose colours and depths are correctly rounded at every pixel.
 *
 * The exact mode beside the precise one of triangle.h: error 1/2 of a step, not more, for every
 * triangle in range, wherever it is. Painters and kernels:
 *
 *      etch_triangle_flat_depth_exact        etch_kernel_flat_exact_less, _lequal
 *      etch_triangle_gouraud_exact           etch_kernel_gouraud_exact
 *      etch_triangle_gouraud_depth_exact     etch_kernel_gouraud_exact_less, _lequal
 *
 * or, for surfaces in rgb565_swapped, the kernels called .._swapped, and for flat triangles the
 * painter of that name. What it costs over the precise mode: tests/tradeoff/README.md.
 */
#ifndef ETCH_DRAW_EXACT_H
#define ETCH_DRAW_EXACT_H

#include "../fragment/exact.h"
#include "triangle.h"

/* In the colour of v[0], with exact depths. */
etch_triangle_painter etch_triangle_flat_depth_exact;
etch_triangle_painter etch_triangle_flat_depth_exact_swapped;

/* Exact colours. */
etch_triangle_painter etch_triangle_gouraud_exact;

/* Exact colours and depths. */
etch_triangle_painter etch_triangle_gouraud_depth_exact;

#endif
