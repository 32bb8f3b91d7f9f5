/* draw/triangle_flat_depth.c: triangles in the colour of their first vertex, with depth. Called
 * by applications and by the mesh's sink. See triangle.h. */
#include "../base/rgb565.h"
#include "../fragment/flat.h"
#include "setup.h"

static void flat_depth(const struct etch_surface *s, const struct etch_vertex *const v[3],
                       etch_kernel *kernel, uint16_t color)
{
    struct etch_flat_depth_paint paint;
    struct etch_triangle t;
    struct etch_basis b;

    if (!setup_visible(&t, s, v))
        return;
    const struct etch_basis *const basis = etch_basis_setup(&b, &t) ? &b : NULL;

    paint.paint.kernel = kernel;
    paint.color = color;
    setup_depth(&paint.z, &t, basis, v);
    etch_triangle_runs(s, &t, &paint.paint);
}

void etch_triangle_flat_depth(const struct etch_surface *s, const struct etch_vertex *const v[3],
                              etch_kernel *kernel)
{
    flat_depth(s, v, kernel, etch_rgb565(v[0]->r, v[0]->g, v[0]->b));
}

void etch_triangle_flat_depth_swapped(const struct etch_surface *s,
                                      const struct etch_vertex *const v[3], etch_kernel *kernel)
{
    flat_depth(s, v, kernel, etch_rgb565_swap(etch_rgb565(v[0]->r, v[0]->g, v[0]->b)));
}
