/* draw/line_varying_alpha.c: alpha along a line. Named by pipelines, called by line_staged.c. See
 * line_staged.h. */
#include "../raster/line_runs.h"
#include "line_staged.h"

/* 8.23 + 1/128, as etch_chunk_alpha reads it. */
static uint32_t value(const struct etch_vertex *v)
{
    return ((uint32_t)v->a << 23) + (UINT32_C(1) << 16);
}

void etch_line_varying_alpha(struct etch_staged_planes *planes,
                             const struct etch_line_varying_input *in)
{
    etch_line_plane(&planes->color.linear.a, in->x0, in->y0, in->x1, in->y1, value(in->v[0]),
                    value(in->v[1]));
}
