/* draw/mesh_primitive.c: a user's function between assembly and clipping. Called by the
 * application. See mesh_elements.h. */
#include "mesh_elements.h"

static void take(struct etch_element_sink *sink, const uint16_t *index)
{
    const struct etch_mesh_primitive *const p = (const void *)sink;
    struct etch_clip_vertex v[3];

    for (uint8_t i = 0; i < 3 && i < p->size; i++)
        p->stage->vertex(p->stage, index[i], &v[i]);
    p->function(p, v);
}

void etch_mesh_primitive_init(struct etch_mesh_primitive *primitive,
                              etch_primitive_function *function, uint8_t size,
                              const struct etch_mesh_stage *stage,
                              const struct etch_assembly *assembly)
{
    primitive->sink.take = take;
    primitive->stage = stage;
    primitive->assembly = assembly;
    primitive->function = function;
    primitive->size = size;
}

void etch_mesh_primitive_triangles(struct etch_mesh_primitive *primitive)
{
    const struct etch_mesh *const mesh = primitive->stage->mesh;
    const uint16_t limit = mesh->vertex_count;

    for (uint16_t t = 0; t < mesh->triangle_count; t++) {
        uint16_t index[3];

        etch_mesh_triangle(mesh, t, index);
        if (index[0] < limit && index[1] < limit && index[2] < limit)
            take(&primitive->sink, index);
    }
}
