/* draw/triangle_gouraud_blend.c: triangles with interpolated colour and alpha. Called by
 * applications and by the mesh's sink. See blend.h. */
#include "../fragment/blend_fused.h"
#include "../raster/alpha_plane.h"
#include "blend.h"
#include "setup.h"

void etch_triangle_gouraud_blend(const struct etch_surface *s, const struct etch_vertex *const v[3],
                                 etch_kernel *kernel)
{
    struct etch_gouraud_blend_paint paint;
    struct etch_triangle t;
    struct etch_basis b;

    if (!setup_visible(&t, s, v))
        return;
    const struct etch_basis *const basis = etch_basis_setup(&b, &t) ? &b : NULL;

    paint.gouraud.paint.kernel = kernel;
    paint.alpha = 0;
    setup_color(&paint.gouraud, &t, basis, v);
    etch_alpha_plane(&paint.a, &t, basis, v);
    etch_triangle_runs(s, &t, &paint.gouraud.paint);
}
