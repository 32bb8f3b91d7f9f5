/* draw/mesh_point_sink.c: the sink that rasterises points. Called by the vertex stage, once a
 * visible point. See mesh_sinks.h. */
#include "mesh_sinks.h"

static void paint(struct etch_sink *sink, const struct etch_vertex *v)
{
    const struct etch_point_sink *const points = (const void *)sink;

    etch_point_paint(points->surface, v, points->size_q8, points->runs, points->kernel);
}

void etch_point_sink_init(struct etch_point_sink *points, const struct etch_surface *surface,
                          uint16_t size_q8, etch_point_runs *runs, etch_kernel *kernel)
{
    points->sink = (struct etch_sink){.point = paint};
    points->surface = surface;
    points->size_q8 = size_q8;
    points->runs = runs;
    points->kernel = kernel;
}
