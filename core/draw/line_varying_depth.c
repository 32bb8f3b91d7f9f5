/* draw/line_varying_depth.c: depth along a line. Named by pipelines, called by line_staged.c. See
 * line_staged.h. */
#include "../raster/line_runs.h"
#include "../raster/plane.h"
#include "line_staged.h"

void etch_line_varying_depth(struct etch_staged_planes *planes,
                             const struct etch_line_varying_input *in)
{
    etch_line_plane(&planes->z, in->x0, in->y0, in->x1, in->y1, etch_depth_q16(in->v[0]->z_q16),
                    etch_depth_q16(in->v[1]->z_q16));
}
