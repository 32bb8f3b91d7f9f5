/* draw/mesh_texture_sink.c: the sink that rasterises textured triangles. Called by the vertex
 * stage, once a visible triangle. See mesh_varying.h. */
#include "mesh_varying.h"

static void paint(struct etch_sink *sink, const struct etch_vertex *const v[3])
{
    const struct etch_texture_sink *const s = (const void *)sink;
    const struct etch_texture_vertex *const wide[3] = {(const void *)v[0], (const void *)v[1],
                                                       (const void *)v[2]};

    s->painter(s->surface, wide, s->texture, s->kernels);
}

void etch_texture_sink_init(struct etch_texture_sink *sink, const struct etch_surface *surface,
                            const struct etch_texture *texture, etch_perspective_painter *painter,
                            const struct etch_perspective_kernels *kernels)
{
    sink->sink = (struct etch_sink){.triangle = paint};
    sink->surface = surface;
    sink->texture = texture;
    sink->painter = painter;
    sink->kernels = kernels;
}
