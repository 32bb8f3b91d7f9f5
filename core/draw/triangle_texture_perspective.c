/* draw/triangle_texture_perspective.c: textured triangles in perspective. Called by applications.
 * See texture.h. */
#include "texture_setup.h"

/* Apart, so that its planes are not on the stack under the affine painter's. */
static ETCH_APART void perspective(const struct etch_surface *s,
                                   const struct etch_texture_vertex *const v[3],
                                   const struct etch_texture *texture,
                                   const struct etch_perspective_kernels *kernels)
{
    const struct etch_vertex *const plain[3] = SETUP_PLAIN(v);
    struct etch_perspective_paint paint;
    struct etch_triangle t;
    struct etch_basis b;

    if (!setup_visible(&t, s, plain))
        return;
    const struct etch_basis *const basis = etch_basis_setup(&b, &t) ? &b : NULL;

    paint.map = setup_map(texture);
    paint.width_bits = texture->width_bits;
    paint.paint.kernel = etch_texture_perspective(&paint.coordinates, &t, basis, v)
                             ? kernels->blocks
                             : kernels->exact;
    etch_triangle_runs(s, &t, &paint.paint);
}

void etch_triangle_perspective(const struct etch_surface *s,
                               const struct etch_texture_vertex *const v[3],
                               const struct etch_texture *texture,
                               const struct etch_perspective_kernels *kernels)
{
    if (v[0]->w == v[1]->w && v[0]->w == v[2]->w)
        etch_triangle_texture(s, v, texture, kernels->affine);
    else
        perspective(s, v, texture, kernels);
}
