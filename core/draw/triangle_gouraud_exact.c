/* draw/triangle_gouraud_exact.c: triangles with exact colours, without depth. Called by
 * applications and by the mesh's sink. See exact.h. */
#include "setup_exact.h"

void etch_triangle_gouraud_exact(const struct etch_surface *s, const struct etch_vertex *const v[3],
                                 etch_kernel *kernel)
{
    struct etch_gouraud_exact_paint paint;
    struct etch_triangle t;
    struct etch_basis b;

    if (!setup_visible(&t, s, v))
        return;
    paint.gouraud.paint.kernel = kernel;
    setup_color(&paint.gouraud, &t, etch_basis_setup(&b, &t) ? &b : NULL, v);
    etch_setup_exact_color(&paint, &t, v);
    etch_triangle_runs(s, &t, &paint.gouraud.paint);
}
