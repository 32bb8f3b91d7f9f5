/* ports/host/scene_mesh.h: a mesh of a scene, between its reading and drawing; no part of the API.
 */
#ifndef ETCH_HOST_SCENE_MESH_H
#define ETCH_HOST_SCENE_MESH_H

#include "../../core/draw/mesh_phong.h"
#include "../../core/draw/mesh_varying.h"
#include "obj.h"
#include "scene_steps.h"

/* A stage for etch_vertex_textured, whose inner function runs the other. */
struct etch_scene_mesh_stage {
    struct etch_mesh_texture_stage textured; /* first */
    struct etch_mesh_shaded_stage lit;       /* also for etch_vertex_lit, which reads less of it */
};

struct etch_scene_mesh {
    struct etch_obj obj;
    struct etch_lighting lighting; /* of etch_vertex_lit .. */
    struct etch_light light[ETCH_SCENE_LIGHTS];
    struct etch_lamps lamps; /* .. or of the lamps, .. */
    struct etch_lamp lamp[ETCH_SCENE_LIGHTS];
    struct etch_material material;
    struct etch_phong phong; /* .. at every pixel */

    struct etch_scene_mesh_stage stage;
    const struct etch_mesh_stage *drawn; /* one of the two in `stage` */
    struct etch_texture texture;         /* that a fused kernel reads */
    struct etch_assembly assembly;
    struct etch_scene_primitive_choice primitive;
    uint8_t varyings; /* 0: the buffer holds etch_mesh_vertex; 2: etch_mesh_texture_vertex; 8:
                         etch_mesh_shade_vertex */
    void *buffer;     /* of transformed vertices, from malloc */
};

/* Everything that does not depend on the strip: matrices, light, the vertices themselves. */
bool etch_scene_mesh_prepare(struct etch_scene_reader *reader, struct etch_scene_mesh *mesh);

/* Whether its light takes lamps and normals: without a light all that counts is the ambient one,
 * and a model may be flat, as a shadow is. */
bool etch_scene_mesh_has_lamps(const struct etch_scene_view *view);

/* Hands the mesh's triangles to a sink. */
void etch_scene_mesh_assemble(const struct etch_scene_mesh *mesh, struct etch_sink *sink);

#endif
