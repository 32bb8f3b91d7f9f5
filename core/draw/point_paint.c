/* draw/point_paint.c: points with the colour and depth of a vertex. Called by applications and
 * sinks. See point.h. */
#include "../fragment/gouraud.h"
#include "../raster/plane.h"
#include "point.h"

void etch_point_paint(const struct etch_surface *s, const struct etch_vertex *v, uint16_t size_q8,
                      etch_point_runs *runs, etch_kernel *kernel)
{
    const struct etch_gouraud_paint paint = {.paint = {kernel},
                                             .z = {etch_depth_q16(v->z_q16), 0, 0},
                                             .r = {etch_channel_q27(v->r), 0, 0},
                                             .g = {etch_channel_q26(v->g), 0, 0},
                                             .b = {etch_channel_q27(v->b), 0, 0}};

    runs(s, v->x_q8, v->y_q8, size_q8, &paint.paint);
}
