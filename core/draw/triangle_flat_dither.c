/* draw/triangle_flat_dither.c: triangles in the dithered colour of their first vertex, without
 * depth. Called by applications and by the mesh's sink. See dither.h. */
#include "setup_dither.h"

void etch_triangle_flat_dither(const struct etch_surface *s, const struct etch_vertex *const v[3],
                               etch_kernel *kernel)
{
    struct etch_gouraud_paint paint;
    struct etch_triangle t;

    if (!setup_visible(&t, s, v))
        return;
    paint.paint.kernel = kernel;
    setup_one_color(&paint, v[0]);
    etch_triangle_runs(s, &t, &paint.paint);
}
