/* draw/line_varying_color.c: colours along a line. Named by pipelines, called by line_staged.c. See
 * line_staged.h. */
#include "../raster/line_runs.h"
#include "../raster/plane.h"
#include "line_staged.h"

void etch_line_varying_color(struct etch_staged_planes *planes,
                             const struct etch_line_varying_input *in)
{
    const struct etch_vertex *const p = in->v[0], *const q = in->v[1];

    etch_line_plane(&planes->color.linear.r, in->x0, in->y0, in->x1, in->y1, etch_channel_q27(p->r),
                    etch_channel_q27(q->r));
    etch_line_plane(&planes->color.linear.g, in->x0, in->y0, in->x1, in->y1, etch_channel_q26(p->g),
                    etch_channel_q26(q->g));
    etch_line_plane(&planes->color.linear.b, in->x0, in->y0, in->x1, in->y1, etch_channel_q27(p->b),
                    etch_channel_q27(q->b));
}
