/* draw/triangle_flat_inverse.c: triangles in the colour of their first vertex, with depth in a
 * floating layout. Called by applications and by the mesh's sink. See inverse.h. */
#include "../base/rgb565.h"
#include "setup_inverse.h"

static void flat(const struct etch_surface *s, const struct etch_vertex *const v[3],
                 etch_kernel *kernel, uint16_t color)
{
    struct etch_flat_inverse_paint paint;
    struct etch_triangle t;
    struct etch_basis b;

    if (!setup_visible(&t, s, v))
        return;
    paint.flat.paint.kernel = kernel;
    paint.flat.color = color;
    paint.up = etch_setup_inverse(&paint.flat.z, &t, etch_basis_setup(&b, &t) ? &b : NULL, v);
    etch_triangle_runs(s, &t, &paint.flat.paint);
}

void etch_triangle_flat_inverse(const struct etch_surface *s, const struct etch_vertex *const v[3],
                                etch_kernel *kernel)
{
    flat(s, v, kernel, etch_rgb565(v[0]->r, v[0]->g, v[0]->b));
}

void etch_triangle_flat_inverse_swapped(const struct etch_surface *s,
                                        const struct etch_vertex *const v[3], etch_kernel *kernel)
{
    flat(s, v, kernel, etch_rgb565_swap(etch_rgb565(v[0]->r, v[0]->g, v[0]->b)));
}
