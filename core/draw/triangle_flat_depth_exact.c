/* draw/triangle_flat_depth_exact.c: triangles in the colour of their first vertex, with exact
 * depth. Called by applications and by the mesh's sink. See exact.h. */
#include "../base/rgb565.h"
#include "setup_exact.h"

static void flat(const struct etch_surface *s, const struct etch_vertex *const v[3],
                 etch_kernel *kernel, uint16_t color)
{
    struct etch_flat_exact_paint paint;
    struct etch_triangle t;
    struct etch_basis b;

    if (!setup_visible(&t, s, v))
        return;
    paint.flat.paint.kernel = kernel;
    paint.flat.color = color;
    setup_depth(&paint.flat.z, &t, etch_basis_setup(&b, &t) ? &b : NULL, v);
    etch_setup_exact_depth(&paint.depth, &t, v);
    etch_triangle_runs(s, &t, &paint.flat.paint);
}

void etch_triangle_flat_depth_exact(const struct etch_surface *s,
                                    const struct etch_vertex *const v[3], etch_kernel *kernel)
{
    flat(s, v, kernel, etch_rgb565(v[0]->r, v[0]->g, v[0]->b));
}

void etch_triangle_flat_depth_exact_swapped(const struct etch_surface *s,
                                            const struct etch_vertex *const v[3],
                                            etch_kernel *kernel)
{
    flat(s, v, kernel, etch_rgb565_swap(etch_rgb565(v[0]->r, v[0]->g, v[0]->b)));
}
