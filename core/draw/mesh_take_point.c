/* draw/mesh_take_point.c: points of a transformed mesh. Called by a kind of vertex/elements. See
 * mesh_elements.h. */
#include "mesh_elements.h"

void etch_mesh_take_point(struct etch_element_sink *sink, const uint16_t *index)
{
    const struct etch_mesh_elements *const e = (const void *)sink;
    const struct etch_mesh_vertex *const v = &e->buffer[index[0]];

    if ((v->out & ETCH_OUT_CLIP) == 0)
        e->assembly->sink->point(e->assembly->sink, &v->v);
}
