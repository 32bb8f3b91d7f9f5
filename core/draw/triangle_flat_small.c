/* draw/triangle_flat_small.c: triangles in the colour of their first vertex, in few bytes. Called
 * by applications and by the mesh's sink. See triangle_small.h. */
#include "../base/rgb565.h"
#include "../fragment/flat.h"
#include "../raster/triangle_small.h"
#include "triangle_small.h"

void etch_triangle_flat_small(const struct etch_surface *s, const struct etch_vertex *const v[3],
                              etch_kernel *kernel)
{
    const struct etch_flat_paint paint = {{kernel}, etch_rgb565(v[0]->r, v[0]->g, v[0]->b)};
    const struct etch_point_q8 p[3] = {
        {v[0]->x_q8, v[0]->y_q8}, {v[1]->x_q8, v[1]->y_q8}, {v[2]->x_q8, v[2]->y_q8}};

    etch_triangle_runs_small(s, p, &paint.paint);
}
