/* draw/mesh_normal.c: the vertex function of shading by pixels. Called through etch_mesh_stage by
 * draw/mesh_varying. See mesh_shaded.h. */
#include "mesh_shaded_point.h"

void etch_vertex_normal(const struct etch_mesh_stage *stage, uint16_t index,
                        struct etch_clip_vertex *out)
{
    /* stage and out are the first members of wider ones */
    const struct etch_mesh_shaded_stage *const wide = (const void *)stage;
    struct etch_clip_shade_vertex *const v = (void *)out;
    struct etch_shade_point point;

    etch_vertex_plain(stage, index, out);
    shaded_point(wide, index, &point);
    v->at.u = v->at.v = 0;
    for (uint8_t i = 0; i < 3; i++) {
        v->normal[i] = point.normal[i];
        v->position[i] = point.position[i];
    }
}
