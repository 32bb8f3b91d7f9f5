/* draw/texture_small.h: textured triangles for programs that count bytes; see triangle_small.h. */
#ifndef ETCH_DRAW_TEXTURE_SMALL_H
#define ETCH_DRAW_TEXTURE_SMALL_H

#include "texture.h"

/* As etch_triangle_perspective_depth with a divide at every pixel, also where all w are equal;
 * kernel: etch_kernel_perspective_less_small, or an exact one of fragment/texture.h. */
void etch_triangle_perspective_depth_small(const struct etch_surface *s,
                                           const struct etch_texture_vertex *const v[3],
                                           const struct etch_texture *texture, etch_kernel *kernel);

#endif
