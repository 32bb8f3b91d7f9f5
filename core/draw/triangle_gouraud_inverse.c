/* draw/triangle_gouraud_inverse.c: triangles with interpolated colour and depth in a floating
 * layout. Called by applications and by the mesh's sink. See inverse.h. */
#include "setup_inverse.h"

void etch_triangle_gouraud_inverse(const struct etch_surface *s,
                                   const struct etch_vertex *const v[3], etch_kernel *kernel)
{
    struct etch_gouraud_inverse_paint paint;
    struct etch_triangle t;
    struct etch_basis b;

    if (!setup_visible(&t, s, v))
        return;
    const struct etch_basis *const basis = etch_basis_setup(&b, &t) ? &b : NULL;

    paint.gouraud.paint.kernel = kernel;
    paint.up = etch_setup_inverse(&paint.gouraud.z, &t, basis, v);
    setup_color(&paint.gouraud, &t, basis, v);
    etch_triangle_runs(s, &t, &paint.gouraud.paint);
}
