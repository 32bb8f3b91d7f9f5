/* draw/staged.c: triangles through stages. Called by applications and by the staged sink. See
 * staged.h. */
#include "staged.h"
#include "setup.h"

void etch_triangle_staged(const struct etch_surface *s, const struct etch_vertex *const v[3],
                          const struct etch_pipeline *pipeline, struct etch_staged_planes *planes)
{
    struct etch_triangle t;
    struct etch_basis b;

    if (!setup_visible(&t, s, v))
        return;
    const struct etch_varying_input in = {&t, etch_basis_setup(&b, &t) ? &b : NULL, v};

    planes->staged.paint.kernel = pipeline->kernel;
    planes->staged.stages = pipeline->stages;
    for (etch_varying *const *varying = pipeline->varyings; *varying != NULL; varying++)
        (*varying)(planes, &in);
    etch_triangle_runs(s, &t, &planes->staged.paint);
}
