/* draw/inverse.h: triangles with depth in a floating layout (fragment/inverse.h), for scenes whose
 * far is thousands of times as far as their near.
 *
 *      etch_triangle_flat_inverse            etch_kernel_flat_inverse_less, _lequal
 *      etch_triangle_gouraud_inverse         etch_kernel_gouraud_inverse_less, _lequal
 *
 * Vertices and sinks are those of triangle.h, so a mesh changes its painter and kernel and nothing
 * else. */
#ifndef ETCH_DRAW_INVERSE_H
#define ETCH_DRAW_INVERSE_H

#include "../fragment/inverse.h"
#include "triangle.h"

/* In the colour of v[0]. */
etch_triangle_painter etch_triangle_flat_inverse;
etch_triangle_painter etch_triangle_flat_inverse_swapped;

/* Colours interpolated, as etch_triangle_gouraud. */
etch_triangle_painter etch_triangle_gouraud_inverse;

#endif
