/* draw/mesh_shaded_point.h: a vertex as lamps see it; no part of the API. */
#ifndef ETCH_DRAW_MESH_SHADED_POINT_H
#define ETCH_DRAW_MESH_SHADED_POINT_H

#include "mesh_shaded.h"

ETCH_INLINE void shaded_point(const struct etch_mesh_shaded_stage *stage, uint16_t index,
                              struct etch_shade_point *point)
{
    struct etch_clip_vertex world;
    int8_t normal[3] = {0, 0, 0};
    int16_t p[3];

    etch_mesh_position(stage->stage.mesh, index, p);
    etch_transform_position(&stage->model, p, &world);
    if (stage->stage.mesh->normals != NULL)
        etch_mesh_normal(stage->stage.mesh, index, normal);
    etch_normal_transform(&stage->normals, normal, point->normal);
    point->position[0] = world.x;
    point->position[1] = world.y;
    point->position[2] = world.z;
}

#endif
