/* draw/mesh_textured.c: meshes with texture coordinates. Called by the application, and through
 * etch_mesh_stage by draw/mesh_varying. See mesh_varying.h. */
#include "mesh_varying.h"

void etch_vertex_textured(const struct etch_mesh_stage *stage, uint16_t index,
                          struct etch_clip_vertex *out)
{
    /* stage and out are the first members of wider ones */
    const struct etch_mesh_texture_stage *const wide = (const void *)stage;
    struct etch_clip_texture_vertex *const textured = (void *)out;
    const int16_t *const from = wide->coordinates + (size_t)index * 2;

    wide->inner(stage, index, out);
    textured->u = etch_saturate_s32(etch_mul_s32(wide->scale_u, from[0]));
    textured->v = etch_saturate_s32(etch_mul_s32(wide->scale_v, from[1]));
}

enum etch_status etch_mesh_draw_textured(const struct etch_mesh_stage *stage,
                                         const struct etch_assembly *assembly,
                                         struct etch_mesh_texture_vertex *buffer, size_t room)
{
    if (room < stage->mesh->vertex_count)
        return ETCH_ENOMEM;
    etch_mesh_transform_varying(stage, &assembly->viewport, buffer, 2);
    etch_mesh_assemble_varying(stage, assembly, buffer, 2);
    return ETCH_OK;
}
