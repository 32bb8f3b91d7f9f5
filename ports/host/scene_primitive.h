/* ports/host/scene_primitive.h: the example primitive functions; no part of the API. */
#ifndef ETCH_HOST_SCENE_PRIMITIVE_H
#define ETCH_HOST_SCENE_PRIMITIVE_H

#include "../../core/draw/mesh_elements.h"
#include "scene_steps.h"

/* A primitive function of triangles and its data behind it, as mesh_elements.h has it. */
struct etch_scene_primitive {
    struct etch_mesh_primitive primitive; /* first */
    uint8_t percent;
};

/* choice->kind is not NONE. Hand on by &it.primitive.sink or etch_mesh_primitive_triangles. */
void etch_scene_primitive_init(struct etch_scene_primitive *primitive,
                               const struct etch_scene_primitive_choice *choice,
                               const struct etch_mesh_stage *stage,
                               const struct etch_assembly *assembly);

/* The statement: none|wireframe|shrink PERCENT */
bool etch_scene_read_primitive(struct etch_scene_reader *reader,
                               const struct etch_scene_statement *statement);

#endif
