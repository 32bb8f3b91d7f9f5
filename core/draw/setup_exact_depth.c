/* draw/setup_exact_depth.c: numerators of a triangle's depth. Called by the exact painters. See
 * setup_exact.h. */
#include "setup_exact.h"

void etch_setup_exact_depth(struct etch_exact_depth *depth, const struct etch_triangle *t,
                            const struct etch_vertex *const v[3])
{
    const uint32_t z[3] = {etch_depth_q16(v[0]->z_q16), etch_depth_q16(v[1]->z_q16),
                           etch_depth_q16(v[2]->z_q16)};

    depth->area = t->area;
    etch_exact_plane_setup(&depth->n, t, z);
}
