/* raster/alpha_plane.c: the plane of a triangle's alpha. Called by draw/ for every visible triangle
 * that needs it. See alpha_plane.h. */
#include "alpha_plane.h"
#include "texture_plane.h"

void etch_alpha_plane(struct etch_plane *a, const struct etch_triangle *t,
                      const struct etch_basis *basis, const struct etch_vertex *const v[3])
{
    uint32_t value[3];

    for (uint8_t i = 0; i < 3; i++)
        value[i] = ((uint32_t)v[i]->a << 23) + (UINT32_C(1) << 16);
    etch_texture_plane(a, t, basis, value);
}
