/* raster/plane_color.c: exact planes of a triangle's colours. Called by draw/ for triangles that
 * basis.c refuses. See plane.h. */
#include "plane.h"

void etch_plane_color(const struct etch_triangle *t, const struct etch_vertex *const v[3],
                      struct etch_plane *red, struct etch_plane *green, struct etch_plane *blue)
{
    uint32_t r[3], g[3], b[3];

    for (uint8_t i = 0; i < 3; i++) {
        r[i] = etch_channel_q27(v[i]->r);
        g[i] = etch_channel_q26(v[i]->g);
        b[i] = etch_channel_q27(v[i]->b);
    }
    etch_plane_setup(red, t, r);
    etch_plane_setup(green, t, g);
    etch_plane_setup(blue, t, b);
}
