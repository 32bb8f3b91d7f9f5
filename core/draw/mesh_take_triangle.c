/* draw/mesh_take_triangle.c: triangles of a transformed mesh. Called by a kind of vertex/elements.
 * See mesh_elements.h. */
#include "mesh_elements.h"

static ETCH_COLD uint8_t clip(const struct etch_mesh_elements *e, const uint16_t index[3],
                              struct etch_vertex out[ETCH_CLIP_MAX])
{
    struct etch_clip_vertex v[3];

    for (int i = 0; i < 3; i++)
        e->stage->vertex(e->stage, index[i], &v[i]);
    return etch_assemble_polygon(e->assembly, v, out);
}

/* A triangle that is flat, or crosses near, far or a guard plane, goes the long way round. */
static ETCH_COLD void assemble_again(const struct etch_mesh_elements *e, const uint16_t index[3])
{
    struct etch_vertex polygon[ETCH_CLIP_MAX];
    const uint8_t n = clip(e, index, polygon);

    etch_assemble_projected(e->assembly, polygon, n);
}

void etch_mesh_take_triangle(struct etch_element_sink *sink, const uint16_t *index)
{
    const struct etch_mesh_elements *const e = (const void *)sink;
    const struct etch_mesh_vertex *const a = &e->buffer[index[0]], *const b = &e->buffer[index[1]];
    const struct etch_mesh_vertex *const c = &e->buffer[index[2]];
    const struct etch_vertex *const v[3] = {&a->v, &b->v, &c->v};

    if ((a->out & b->out & c->out & ETCH_OUT_REJECT) != 0)
        return;
    if (((a->out | b->out | c->out) & ETCH_OUT_CLIP) != 0)
        assemble_again(e, index);
    else if (!etch_cull_keeps(e->assembly->cull, v))
        return;
    else if (e->assembly->flat)
        assemble_again(e, index);
    else
        e->assembly->sink->triangle(e->assembly->sink, v);
}
