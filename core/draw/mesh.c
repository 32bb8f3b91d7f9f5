/* draw/mesh.c: vertices once, then triangles by index. Called by the application, whole or in
 * its two halves. See mesh.h. */
#include "mesh.h"

void etch_mesh_transform_range(const struct etch_mesh_stage *stage,
                               const struct etch_viewport *viewport,
                               struct etch_mesh_vertex *buffer, uint16_t first, uint16_t end)
{
    for (uint16_t i = first; i < end; i++) {
        struct etch_clip_vertex v;

        stage->vertex(stage, i, &v);
        buffer[i].out = etch_viewport_outcode(viewport, &v);
        if ((buffer[i].out & ETCH_OUT_CLIP) == 0)
            etch_viewport_project(viewport, &v, &buffer[i].v);
    }
}

void etch_mesh_transform(const struct etch_mesh_stage *stage, const struct etch_viewport *viewport,
                         struct etch_mesh_vertex *buffer)
{
    etch_mesh_transform_range(stage, viewport, buffer, 0, stage->mesh->vertex_count);
}

static ETCH_COLD uint8_t clip(const struct etch_mesh_stage *stage,
                              const struct etch_assembly *assembly, const uint16_t index[3],
                              struct etch_vertex out[ETCH_CLIP_MAX])
{
    struct etch_clip_vertex v[3];

    for (int i = 0; i < 3; i++)
        stage->vertex(stage, index[i], &v[i]);
    return etch_assemble_polygon(assembly, v, out);
}

/* A triangle that crosses near, far or a guard plane goes the long way round. */
static ETCH_COLD void assemble_clipped(const struct etch_mesh_stage *stage,
                                       const struct etch_assembly *assembly,
                                       const uint16_t index[3])
{
    struct etch_vertex polygon[ETCH_CLIP_MAX];
    const uint8_t n = clip(stage, assembly, index, polygon);

    etch_assemble_projected(assembly, polygon, n);
}

/* All in the colour of v[0]. */
static ETCH_COLD void emit_flat(struct etch_sink *sink, const struct etch_vertex *const v[3])
{
    struct etch_vertex same[2] = {*v[1], *v[2]};
    const struct etch_vertex *const flat[3] = {v[0], &same[0], &same[1]};

    for (int i = 0; i < 2; i++) {
        same[i].r = v[0]->r;
        same[i].g = v[0]->g;
        same[i].b = v[0]->b;
        same[i].a = v[0]->a;
    }
    sink->triangle(sink, flat);
}

void etch_mesh_assemble(const struct etch_mesh_stage *stage, const struct etch_assembly *assembly,
                        const struct etch_mesh_vertex *buffer)
{
    const struct etch_mesh *mesh = stage->mesh;
    const uint16_t count = mesh->vertex_count;

    for (uint16_t t = 0; t < mesh->triangle_count; t++) {
        uint16_t index[3];

        etch_mesh_triangle(mesh, t, index);
        if (index[0] >= count || index[1] >= count || index[2] >= count)
            continue;
        const struct etch_mesh_vertex *a = &buffer[index[0]];
        const struct etch_mesh_vertex *b = &buffer[index[1]];
        const struct etch_mesh_vertex *c = &buffer[index[2]];
        const struct etch_vertex *const v[3] = {&a->v, &b->v, &c->v};

        if ((a->out & b->out & c->out & ETCH_OUT_REJECT) != 0)
            continue;
        if (((a->out | b->out | c->out) & ETCH_OUT_CLIP) != 0)
            assemble_clipped(stage, assembly, index);
        else if (!etch_cull_keeps(assembly->cull, v))
            continue;
        else if (assembly->flat)
            emit_flat(assembly->sink, v);
        else
            assembly->sink->triangle(assembly->sink, v);
    }
}

enum etch_status etch_mesh_draw(const struct etch_mesh_stage *stage,
                                const struct etch_assembly *assembly,
                                struct etch_mesh_vertex *buffer, size_t room)
{
    if (room < stage->mesh->vertex_count)
        return ETCH_ENOMEM;
    etch_mesh_transform(stage, &assembly->viewport, buffer);
    etch_mesh_assemble(stage, assembly, buffer);
    return ETCH_OK;
}
