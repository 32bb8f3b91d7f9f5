/* draw/triangle_gouraud_depth.c: triangles with interpolated colour and depth. Called by
 * applications and by the mesh's sink. See triangle.h. */
#include "../fragment/gouraud.h"
#include "setup.h"

void etch_triangle_gouraud_depth(const struct etch_surface *s, const struct etch_vertex *const v[3],
                                 etch_kernel *kernel)
{
    struct etch_gouraud_paint paint;
    struct etch_triangle t;
    struct etch_basis b;

    if (!setup_visible(&t, s, v))
        return;
    const struct etch_basis *const basis = etch_basis_setup(&b, &t) ? &b : NULL;

    paint.paint.kernel = kernel;
    setup_depth(&paint.z, &t, basis, v);
    setup_color(&paint, &t, basis, v);
    etch_triangle_runs(s, &t, &paint.paint);
}
