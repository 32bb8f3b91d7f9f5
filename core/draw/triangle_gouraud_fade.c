/* draw/triangle_gouraud_fade.c: triangles with interpolated colour and one alpha. Called by
 * applications and by the mesh's sink. See blend.h. */
#include "../fragment/blend_fused.h"
#include "blend.h"
#include "setup.h"

void etch_triangle_gouraud_fade(const struct etch_surface *s, const struct etch_vertex *const v[3],
                                etch_kernel *kernel)
{
    struct etch_gouraud_blend_paint paint;
    struct etch_triangle t;
    struct etch_basis b;

    if (!setup_visible(&t, s, v))
        return;
    paint.gouraud.paint.kernel = kernel;
    paint.alpha = (uint16_t)(v[0]->a * 256U);
    setup_color(&paint.gouraud, &t, etch_basis_setup(&b, &t) ? &b : NULL, v);
    etch_triangle_runs(s, &t, &paint.gouraud.paint);
}
