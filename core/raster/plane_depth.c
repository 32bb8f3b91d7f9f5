/* raster/plane_depth.c: the exact plane of a triangle's depth. Called by draw/ for triangles that
 * basis_depth.c refuses. See plane.h. */
#include "plane.h"

void etch_plane_depth(const struct etch_triangle *t, const struct etch_vertex *const v[3],
                      struct etch_plane *z)
{
    const uint32_t value[3] = {etch_depth_q16(v[0]->z_q16), etch_depth_q16(v[1]->z_q16),
                               etch_depth_q16(v[2]->z_q16)};

    etch_plane_setup(z, t, value);
}
