/* draw/mesh_lit_small.c: the lit vertex function in few bytes, apart so that programs without light
 * do not link it. Called through etch_mesh_stage. See mesh_small.h. */
#include "mesh_small.h"

void etch_vertex_lit_small(const struct etch_mesh_stage *stage, uint16_t index,
                           struct etch_clip_vertex *out)
{
    int8_t normal[3] = {0, 0, 0};

    etch_vertex_plain_small(stage, index, out);
    if (stage->mesh->normals != NULL)
        etch_mesh_normal(stage->mesh, index, normal);

    uint8_t rgb[3] = {out->r, out->g, out->b};
    etch_light_vertex(stage->lighting, normal, rgb);
    out->r = rgb[0];
    out->g = rgb[1];
    out->b = rgb[2];
}
