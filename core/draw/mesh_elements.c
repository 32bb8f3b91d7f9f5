/* draw/mesh_elements.c: set-up of element sinks. Called by the application. See mesh_elements.h. */
#include "mesh_elements.h"

void etch_mesh_elements_init(struct etch_mesh_elements *elements, etch_element_taker *taker,
                             const struct etch_mesh_stage *stage,
                             const struct etch_assembly *assembly,
                             const struct etch_mesh_vertex *buffer)
{
    elements->sink.take = taker;
    elements->stage = stage;
    elements->assembly = assembly;
    elements->buffer = buffer;
}
