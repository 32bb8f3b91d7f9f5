/* draw/triangle_texture_depth.c: affine textured triangles with depth. Called by applications. See
 * texture.h. */
#include "texture_setup.h"

void etch_triangle_texture_depth(const struct etch_surface *s,
                                 const struct etch_texture_vertex *const v[3],
                                 const struct etch_texture *texture, etch_kernel *kernel)
{
    const struct etch_vertex *const plain[3] = SETUP_PLAIN(v);
    struct etch_texture_paint paint;
    struct etch_triangle t;
    struct etch_basis b;

    if (!setup_visible(&t, s, plain))
        return;
    const struct etch_basis *const basis = etch_basis_setup(&b, &t) ? &b : NULL;

    paint.paint.kernel = kernel;
    paint.map = setup_map(texture);
    setup_depth(&paint.z, &t, basis, plain);
    etch_texture_affine(&paint.u, &paint.v, &t, basis, v, texture->width_bits);
    etch_triangle_runs(s, &t, &paint.paint);
}
