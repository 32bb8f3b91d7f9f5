/* draw/name_sink.c: triangles in names. Called by the vertex stage, once a visible triangle. See
 * select.h. */
#include "../fragment/flat.h"
#include "select.h"
#include "setup.h"

static void paint(struct etch_sink *sink, const struct etch_vertex *const v[3])
{
    const struct etch_name_sink *const names = (const void *)sink;
    struct etch_flat_depth_paint flat;
    struct etch_triangle t;
    struct etch_basis b;

    if (!setup_visible(&t, names->surface, v))
        return;
    const struct etch_basis *const basis = etch_basis_setup(&b, &t) ? &b : NULL;

    flat.paint.kernel = names->kernel;
    flat.color = names->name;
    setup_depth(&flat.z, &t, basis, v);
    etch_triangle_runs(names->surface, &t, &flat.paint);
}

void etch_name_sink_init(struct etch_name_sink *names, const struct etch_surface *surface,
                         etch_kernel *kernel)
{
    names->sink = (struct etch_sink){.triangle = paint};
    names->surface = surface;
    names->kernel = kernel;
    names->name = 0;
}
