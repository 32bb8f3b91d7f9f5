/* draw/mesh_sink.c: the sink that rasterises. Called by the vertex stage, once a visible
 * triangle. See mesh.h. */
#include "mesh.h"

static void paint(struct etch_sink *sink, const struct etch_vertex *const v[3])
{
    /* sink is the first member, so it has the raster sink's address */
    const struct etch_raster_sink *raster = (const struct etch_raster_sink *)(void *)sink;

    raster->painter(raster->surface, v, raster->kernel);
}

void etch_raster_sink_init(struct etch_raster_sink *raster, const struct etch_surface *surface,
                           etch_triangle_painter *painter, etch_kernel *kernel)
{
    raster->sink = (struct etch_sink){.triangle = paint};
    raster->surface = surface;
    raster->painter = painter;
    raster->kernel = kernel;
}
