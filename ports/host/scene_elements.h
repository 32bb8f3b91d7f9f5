/* ports/host/scene_elements.h: primitives from lists of vertices; no part of the API. */
#ifndef ETCH_HOST_SCENE_ELEMENTS_H
#define ETCH_HOST_SCENE_ELEMENTS_H

#include "../../core/draw/mesh_elements.h"
#include "scene_steps.h"

enum {
    ETCH_SCENE_VERTICES = 256,
    ETCH_SCENE_INDICES = 1024,
    ETCH_SCENE_ELEMENTS = 7 /* kinds of primitives */
};

struct etch_scene_element_vertex {
    etch_q16 p[3];
    uint8_t rgba[4];
};

struct elements {
    struct etch_mesh_stage stage; /* first: the vertex function finds the rest behind it */
    struct etch_mesh mesh;
    struct etch_matrix matrix;
    struct etch_assembly assembly;
    etch_element_kind *kind;
    etch_element_taker *taker;
    struct etch_scene_primitive_choice primitive; /* of triangles */
    uint16_t size_q8;                             /* of points */
    uint32_t index_count;
    uint16_t index[ETCH_SCENE_INDICES];
    struct etch_scene_element_vertex vertex[ETCH_SCENE_VERTICES];
    struct etch_mesh_vertex buffer[ETCH_SCENE_VERTICES];
};

/* How each kind of primitives is assembled and drawn, in the order of the words of `list`. */
struct etch_scene_element_kind {
    etch_element_kind *kind;
    etch_element_taker *taker;
    struct etch_scene_statement statement; /* of the step; below with shrink, wireframe */
    struct etch_scene_statement by_primitive[2];
};
extern const struct etch_scene_element_kind etch_scene_element_kinds[ETCH_SCENE_ELEMENTS];

/* Hands the primitives of a step of `list` to a sink: points, lines or triangles. */
void etch_scene_elements_assemble(const struct etch_scene_step *step, struct etch_sink *sink);

#endif
