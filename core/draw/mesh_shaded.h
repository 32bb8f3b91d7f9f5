/* draw/mesh_shaded.h: meshes under lamps (vertex/lamp.h): Gouraud shading here, Phong shading with
 * fragment/phong.h. */
#ifndef ETCH_DRAW_MESH_SHADED_H
#define ETCH_DRAW_MESH_SHADED_H

#include "../vertex/lamp.h"
#include "../vertex/normal.h"
#include "../vertex/varying.h"
#include "mesh.h"

struct etch_mesh_shaded_stage {
    struct etch_mesh_stage stage;      /* first; by etch_mesh_stage_init */
    struct etch_transform model;       /* model to world space */
    struct etch_normal_matrix normals; /* of the same matrix */
    etch_shade_function *shade;        /* etch_shade_diffuse, _phong, _blinn or your own, with .. */
    const void *lighting;              /* .. its data; the caller's */
};

/* Prepares a stage whose vertex function is etch_vertex_shaded: etch_mesh_stage_init, and the
 * model's place in the world. ETCH_EINVAL, and *stage not to be used, if it flattens normals to
 * nothing (vertex/normal.h). */
enum etch_status etch_mesh_shaded_init(struct etch_mesh_shaded_stage *stage,
                                       const struct etch_mesh *mesh,
                                       const struct etch_matrix *model_to_clip,
                                       const struct etch_matrix *model_to_world,
                                       etch_shade_function *shade, const void *lighting);

/* Position transformed, colour = mesh color * stage color / 255, shaded at the vertex: Gouraud, and
 * with `flat` assemblies the shading of vertex 0. A mesh without normals is as dark as ambient
 * light leaves it. */
etch_vertex_function etch_vertex_shaded;

/* ---- for shading by pixels ------------------------------------------------------------------- */

/* A vertex that carries what a pixel's shading needs: 8 varyings in all. */
struct etch_clip_shade_vertex {
    struct etch_clip_texture_vertex at;
    int32_t normal[3];    /* unit, 2.14 */
    etch_q16 position[3]; /* world space */
};

/* The same on the screen. */
struct etch_shade_vertex {
    struct etch_texture_vertex at;
    int32_t normal[3];
    etch_q16 position[3];
};

/* What etch_mesh_transform_varying and etch_mesh_assemble_varying keep of it, with count = 8. */
struct etch_mesh_shade_vertex {
    struct etch_shade_vertex v;
    uint32_t out;
};
#define ETCH_SHADE_VARYINGS 8

/* The vertex function for it: position and colour unlit, u = v = 0, normal and position in world
 * space. In a stage of etch_mesh_shaded_init, put into stage.vertex. */
etch_vertex_function etch_vertex_normal;

#endif
