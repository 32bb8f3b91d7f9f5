/* draw/line_wide_staged.c: a line as two triangles through stages. Called by applications and
 * sinks. See line_staged.h. */
#include "line.h"
#include "line_staged.h"

void etch_line_wide_staged(const struct etch_surface *s, const struct etch_vertex *const v[2],
                           uint16_t width_q8, const struct etch_pipeline *pipeline,
                           struct etch_staged_planes *planes)
{
    struct etch_vertex c[4];

    if (!etch_line_wide_corners(c, v, width_q8))
        return;
    const struct etch_vertex *const first[3] = {&c[0], &c[1], &c[2]};
    const struct etch_vertex *const second[3] = {&c[0], &c[2], &c[3]};

    etch_triangle_staged(s, first, pipeline, planes);
    etch_triangle_staged(s, second, pipeline, planes);
}
