/* draw/triangle_texture_small.c: textured triangles in perspective, with depth, in few bytes.
 * Called by applications. See texture_small.h. */
#include "../raster/plane.h"
#include "../raster/texture_small.h"
#include "../raster/triangle_small.h"
#include "texture_setup.h"
#include "texture_small.h"

void etch_triangle_perspective_depth_small(const struct etch_surface *s,
                                           const struct etch_texture_vertex *const v[3],
                                           const struct etch_texture *texture, etch_kernel *kernel)
{
    struct etch_perspective_paint paint;
    struct etch_point_q8 p[3];
    uint32_t z[3];

    for (uint8_t i = 0; i < 3; i++) {
        p[i].x = v[i]->at.x_q8;
        p[i].y = v[i]->at.y_q8;
        z[i] = etch_depth_q16(v[i]->at.z_q16);
    }
    if (!etch_plane_setup_small(&paint.z, p, z))
        return;
    paint.paint.kernel = kernel;
    paint.map = setup_map(texture);
    paint.width_bits = texture->width_bits;
    etch_texture_perspective_small(&paint.coordinates, p, v);
    etch_triangle_runs_small(s, p, &paint.paint);
}
