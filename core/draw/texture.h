/* draw/texture.h: textured triangles.
 *
 * The texel at the pixel's centre, repeated; see base/texture.h for textures and vertices, and
 * fragment/texture.h for the kernels. Every vertex in the ranges of base/sink.h is legal, with
 * every u, v and w. Bounds: raster/texture_plane.h. `texture` is read during the call only.
 */
#ifndef ETCH_DRAW_TEXTURE_H
#define ETCH_DRAW_TEXTURE_H

#include "../base/texture.h"

/* Coordinates linear on the screen; kernel: etch_kernel_texture. */
void etch_triangle_texture(const struct etch_surface *s,
                           const struct etch_texture_vertex *const v[3],
                           const struct etch_texture *texture, etch_kernel *kernel);

/* The same with depth; kernel: etch_kernel_texture_less, _lequal. */
void etch_triangle_texture_depth(const struct etch_surface *s,
                                 const struct etch_texture_vertex *const v[3],
                                 const struct etch_texture *texture, etch_kernel *kernel);

/* The kernels of one way to draw in perspective. The triangle chooses: `affine` where all w are
 * equal, which gives the pixels of the affine painters; `blocks` where a divide every 16 pixels
 * does; `exact` elsewhere. Put the same kernel into the last two to have every pixel exact, or to
 * link less. */
struct etch_perspective_kernels {
    etch_kernel *affine, *blocks, *exact;
};

extern const struct etch_perspective_kernels etch_perspective;      /* no depth */
extern const struct etch_perspective_kernels etch_perspective_less; /* a divide every 16 pixels */
extern const struct etch_perspective_kernels etch_perspective_lequal;
extern const struct etch_perspective_kernels etch_perspective_exact; /* a divide every pixel */
extern const struct etch_perspective_kernels etch_perspective_exact_less;
extern const struct etch_perspective_kernels etch_perspective_exact_lequal;

/* In perspective; kernels: &etch_perspective, &etch_perspective_exact. */
void etch_triangle_perspective(const struct etch_surface *s,
                               const struct etch_texture_vertex *const v[3],
                               const struct etch_texture *texture,
                               const struct etch_perspective_kernels *kernels);

/* The same with depth; kernels: the other four. */
void etch_triangle_perspective_depth(const struct etch_surface *s,
                                     const struct etch_texture_vertex *const v[3],
                                     const struct etch_texture *texture,
                                     const struct etch_perspective_kernels *kernels);

#endif
