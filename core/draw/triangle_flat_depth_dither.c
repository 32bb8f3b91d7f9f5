/* draw/triangle_flat_depth_dither.c: triangles in the dithered colour of their first vertex, with
 * depth. Called by applications and by the mesh's sink. See dither.h. */
#include "setup_dither.h"

void etch_triangle_flat_depth_dither(const struct etch_surface *s,
                                     const struct etch_vertex *const v[3], etch_kernel *kernel)
{
    struct etch_gouraud_paint paint;
    struct etch_triangle t;
    struct etch_basis b;

    if (!setup_visible(&t, s, v))
        return;
    paint.paint.kernel = kernel;
    setup_depth(&paint.z, &t, etch_basis_setup(&b, &t) ? &b : NULL, v);
    setup_one_color(&paint, v[0]);
    etch_triangle_runs(s, &t, &paint.paint);
}
