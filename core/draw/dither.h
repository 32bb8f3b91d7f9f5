/* draw/dither.h: flat triangles in a colour between two of RGB565.
 *
 * Interpolated triangles are dithered by the painters of triangle.h with the kernels of
 * fragment/dither.h. Those of one colour take the same kernels from here. */
#ifndef ETCH_DRAW_DITHER_H
#define ETCH_DRAW_DITHER_H

#include "../fragment/dither.h"
#include "triangle.h"

/* In the colour of v[0], with etch_kernel_gouraud_dither, or _less and _lequal with depth. Each
 * channel is dithered between the two nearest steps: fragment/dither.h has the bound. */
etch_triangle_painter etch_triangle_flat_dither;
etch_triangle_painter etch_triangle_flat_depth_dither;

#endif
