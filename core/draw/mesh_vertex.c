/* draw/mesh_vertex.c: the shipped vertex functions. Called through etch_mesh_stage by draw/mesh.
 * See mesh.h. */
#include "mesh.h"

void etch_mesh_stage_init(struct etch_mesh_stage *stage, const struct etch_mesh *mesh,
                          const struct etch_matrix *model_to_clip, etch_vertex_function *vertex,
                          const struct etch_lighting *lighting)
{
    stage->mesh = mesh;
    stage->vertex = vertex;
    etch_transform_init(&stage->transform, model_to_clip, mesh->bits, mesh->extent);
    stage->lighting = lighting;
    for (int i = 0; i < 4; i++)
        stage->color[i] = 255;
}

/* round(a * b / 255). */
static uint8_t modulate(uint8_t a, uint8_t b)
{
    const uint32_t product = (uint32_t)a * b + 128;

    return (uint8_t)((product + (product >> 8)) >> 8);
}

void etch_vertex_plain(const struct etch_mesh_stage *stage, uint16_t index,
                       struct etch_clip_vertex *out)
{
    int16_t p[3];
    uint8_t rgb[3];

    etch_mesh_position(stage->mesh, index, p);
    etch_transform_position(&stage->transform, p, out);
    etch_mesh_color(stage->mesh, index, rgb);
    out->r = modulate(rgb[0], stage->color[0]);
    out->g = modulate(rgb[1], stage->color[1]);
    out->b = modulate(rgb[2], stage->color[2]);
    out->a = stage->color[3];
}
