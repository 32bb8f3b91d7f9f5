/* draw/triangle_texture.c: affine textured triangles. Called by applications. See texture.h. */
#include "texture_setup.h"

void etch_triangle_texture(const struct etch_surface *s,
                           const struct etch_texture_vertex *const v[3],
                           const struct etch_texture *texture, etch_kernel *kernel)
{
    const struct etch_vertex *const plain[3] = SETUP_PLAIN(v);
    struct etch_texture_paint paint;
    struct etch_triangle t;
    struct etch_basis b;

    if (!setup_visible(&t, s, plain))
        return;
    paint.paint.kernel = kernel;
    paint.map = setup_map(texture);
    etch_texture_affine(&paint.u, &paint.v, &t, etch_basis_setup(&b, &t) ? &b : NULL, v,
                        texture->width_bits);
    etch_triangle_runs(s, &t, &paint.paint);
}
