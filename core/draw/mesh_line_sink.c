/* draw/mesh_line_sink.c: the sink that rasterises lines. Called by the vertex stage, once a visible
 * line. See mesh_sinks.h. */
#include "mesh_sinks.h"

static void paint(struct etch_sink *sink, const struct etch_vertex *const v[2])
{
    const struct etch_line_sink *const lines = (const void *)sink;

    lines->painter(lines->surface, v, lines->kernel);
}

void etch_line_sink_init(struct etch_line_sink *lines, const struct etch_surface *surface,
                         etch_line_painter *painter, etch_kernel *kernel)
{
    lines->sink = (struct etch_sink){.line = paint};
    lines->surface = surface;
    lines->painter = painter;
    lines->kernel = kernel;
}
