/* draw/blend.h: triangles blended over what is there, without depth, in one loop a pixel. Painters
 * as those of draw/triangle.h, with the kernels of fragment/blend_fused.h; everything else:
 * staged.h. */
#ifndef ETCH_DRAW_BLEND_H
#define ETCH_DRAW_BLEND_H

#include "triangle.h"

/* In the colour of v[0] with its alpha; kernel: etch_kernel_flat_blend, .._swapped. */
etch_triangle_painter etch_triangle_flat_blend;

/* Colours and alpha linear on the screen; kernel: etch_kernel_gouraud_blend, .._swapped. */
etch_triangle_painter etch_triangle_gouraud_blend;

/* Colours linear on the screen with the alpha of v[0]; kernel: etch_kernel_gouraud_fade,
 * .._swapped. */
etch_triangle_painter etch_triangle_gouraud_fade;

#endif
