/* draw/staged_sink.c: triangles of the vertex stage through stages. Called by assembly through the
 * sink. See staged.h. */
#include "staged.h"

static void take(struct etch_sink *sink, const struct etch_vertex *const v[3])
{
    const struct etch_staged_sink *const s = (const struct etch_staged_sink *)(const void *)sink;

    etch_triangle_staged(s->surface, v, s->pipeline, s->planes);
}

void etch_staged_sink_init(struct etch_staged_sink *staged, const struct etch_surface *surface,
                           const struct etch_pipeline *pipeline, struct etch_staged_planes *planes)
{
    const struct etch_sink sink = {take, NULL, NULL};

    staged->sink = sink;
    staged->surface = surface;
    staged->pipeline = pipeline;
    staged->planes = planes;
}
