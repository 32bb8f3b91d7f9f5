/* draw/triangle_gouraud_depth_small.c: triangles with interpolated colour and depth, in few bytes.
 * Called by applications and by the mesh's sink. See triangle_small.h. */
#include "../fragment/gouraud.h"
#include "setup_small.h"

void etch_triangle_gouraud_depth_small(const struct etch_surface *s,
                                       const struct etch_vertex *const v[3], etch_kernel *kernel)
{
    struct etch_gouraud_paint paint;
    struct etch_point_q8 p[3];
    uint32_t z[3];

    paint.paint.kernel = kernel;
    for (uint8_t i = 0; i < 3; i++)
        z[i] = etch_depth_q16(v[i]->z_q16);
    if (etch_setup_small(&paint, p, v) && etch_plane_setup_small(&paint.z, p, z))
        etch_triangle_runs_small(s, p, &paint.paint);
}
