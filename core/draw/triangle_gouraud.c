/* draw/triangle_gouraud.c: triangles with interpolated colour, without depth. Called by
 * applications and by the mesh's sink. See triangle.h. */
#include "../fragment/gouraud.h"
#include "setup.h"

void etch_triangle_gouraud(const struct etch_surface *s, const struct etch_vertex *const v[3],
                           etch_kernel *kernel)
{
    struct etch_gouraud_paint paint;
    struct etch_triangle t;

    if (!setup_visible(&t, s, v))
        return;
    paint.paint.kernel = kernel;
    setup_color(&paint.r, &paint.g, &paint.b, &t, v);
    etch_triangle_runs(s, &t, &paint.paint);
}
