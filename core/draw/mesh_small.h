/* draw/mesh_small.h: meshes for programs that count bytes: no vertex buffer, no fast paths. Stages,
 * assembly and sinks are those of mesh.h, and so are the triangles that the sink gets, but for
 * those that are clipped (vertex/assembly_small.h). */
#ifndef ETCH_DRAW_MESH_SMALL_H
#define ETCH_DRAW_MESH_SMALL_H

#include "mesh.h"

/* As etch_mesh_stage_init. */
void etch_mesh_stage_init_small(struct etch_mesh_stage *stage, const struct etch_mesh *mesh,
                                const struct etch_matrix *model_to_clip,
                                etch_vertex_function *vertex, const struct etch_lighting *lighting);

/* As etch_vertex_plain and etch_vertex_lit, which small stages may have too. */
etch_vertex_function etch_vertex_plain_small;
etch_vertex_function etch_vertex_lit_small;

/* As etch_mesh_draw, running the vertex function three times a triangle. */
void etch_mesh_draw_small(const struct etch_mesh_stage *stage,
                          const struct etch_assembly *assembly);

#endif
