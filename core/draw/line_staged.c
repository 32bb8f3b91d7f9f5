/* draw/line_staged.c: lines through stages. Called by applications and sinks. See line_staged.h. */
#include "line_staged.h"

#include "line_setup.h"

void etch_line_staged(const struct etch_surface *s, const struct etch_vertex *const v[2],
                      const struct etch_line_pipeline *pipeline, struct etch_staged_planes *planes)
{
    struct line_setup l;

    if (!line_setup(&l, s, v))
        return;
    const struct etch_line_varying_input in = {l.x0, l.y0, l.x1, l.y1, v};

    planes->staged.paint.kernel = pipeline->kernel;
    planes->staged.stages = pipeline->stages;
    for (etch_line_varying *const *varying = pipeline->varyings; *varying != NULL; varying++)
        (*varying)(planes, &in);
    etch_line_steps_runs(s, &l.steps, &planes->staged.paint);
}
