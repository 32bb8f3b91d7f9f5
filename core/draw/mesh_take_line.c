/* draw/mesh_take_line.c: lines of a transformed mesh. Called by a kind of vertex/elements. See
 * mesh_elements.h. */
#include "mesh_elements.h"

/* A line that is flat, or crosses near, far or a guard plane, goes the long way round. */
static ETCH_COLD void assemble_again(const struct etch_mesh_elements *e, const uint16_t index[2])
{
    struct etch_clip_vertex v[2];

    for (int i = 0; i < 2; i++)
        e->stage->vertex(e->stage, index[i], &v[i]);
    etch_assemble_line(e->assembly, v);
}

void etch_mesh_take_line(struct etch_element_sink *sink, const uint16_t *index)
{
    const struct etch_mesh_elements *const e = (const void *)sink;
    const struct etch_mesh_vertex *const a = &e->buffer[index[0]], *const b = &e->buffer[index[1]];
    const struct etch_vertex *const line[2] = {&a->v, &b->v};

    if ((a->out & b->out & ETCH_OUT_REJECT) != 0)
        return;
    if (((a->out | b->out) & ETCH_OUT_CLIP) != 0 || e->assembly->flat)
        assemble_again(e, index);
    else
        e->assembly->sink->line(e->assembly->sink, line);
}
