/* draw/point_staged.c: points through stages. Called by applications and sinks. See line_staged.h.
 */
#include "line_staged.h"

void etch_point_staged(const struct etch_surface *s, const struct etch_vertex *v, uint16_t size_q8,
                       etch_point_runs *runs, const struct etch_line_pipeline *pipeline,
                       struct etch_staged_planes *planes)
{
    const struct etch_vertex *const ends[2] = {v, v};
    const struct etch_line_varying_input in = {0, 0, 0, 0, ends}; /* planes of one value */

    planes->staged.paint.kernel = pipeline->kernel;
    planes->staged.stages = pipeline->stages;
    for (etch_line_varying *const *varying = pipeline->varyings; *varying != NULL; varying++)
        (*varying)(planes, &in);
    runs(s, v->x_q8, v->y_q8, size_q8, &planes->staged.paint);
}
