/* draw/mesh_varying.h: meshes whose vertices have texture coordinates, or more.
 *
 * As draw/mesh.h, with wider vertices (vertex/varying.h) from the vertex function to the sink. The
 * stage is an etch_mesh_stage whose vertex function sets a vertex that begins with
 * struct etch_clip_texture_vertex; the sink gets one that begins with struct etch_texture_vertex.
 */
#ifndef ETCH_DRAW_MESH_VARYING_H
#define ETCH_DRAW_MESH_VARYING_H

#include "../vertex/varying.h"
#include "mesh.h"
#include "texture.h"

/* ---- textured meshes ------------------------------------------------------------------------- */

/* A stage with texture coordinates: u = s scale_u, v = t scale_v, saturated to 16.16. */
struct etch_mesh_texture_stage {
    struct etch_mesh_stage stage; /* first; by etch_mesh_stage_init with etch_vertex_textured */
    etch_vertex_function *inner;  /* position and colour: etch_vertex_plain, a lit one, yours */
    const int16_t *coordinates;   /* s, t per vertex of the mesh; the caller's */
    etch_q16 scale_u, scale_v;    /* texels to one unit of s and t: for coordinates in 2^-12 of the
                                     texture and one of 64 texels, 64 * 65536 / 4096 */
};

/* Runs `inner`, then sets u and v. For stages as above and vertices that begin with
 * struct etch_clip_texture_vertex. */
etch_vertex_function etch_vertex_textured;

/* What is kept of a vertex: 32 bytes. */
struct etch_mesh_texture_vertex {
    struct etch_texture_vertex v; /* not set where out has a bit of ETCH_OUT_CLIP */
    uint32_t out;                 /* outcode */
};

/* Draws a textured mesh: the sink gets etch_texture_vertex. `buffer` is the caller's.
 * ETCH_ENOMEM, and nothing drawn, if `room`, the vertices that it holds, is less than
 * mesh->vertex_count. */
enum etch_status etch_mesh_draw_textured(const struct etch_mesh_stage *stage,
                                         const struct etch_assembly *assembly,
                                         struct etch_mesh_texture_vertex *buffer, size_t room);

/* ---- the two halves, for any count of varyings, 2 .. ETCH_VARYINGS -------------------------- */

/* Like etch_mesh_transform and etch_mesh_assemble. An element of the buffer is the vertex that the
 * sink gets and after it the outcode: for count = 2 etch_mesh_texture_vertex, for more
 *      struct { struct etch_texture_vertex v; int32_t more[count - 2]; uint32_t out; }. */
void etch_mesh_transform_varying(const struct etch_mesh_stage *stage,
                                 const struct etch_viewport *viewport, void *buffer, uint8_t count);
void etch_mesh_assemble_varying(const struct etch_mesh_stage *stage,
                                const struct etch_assembly *assembly, const void *buffer,
                                uint8_t count);

/* Hands on one triangle of the transformed mesh, as etch_mesh_assemble_varying does with each. */
void etch_mesh_triangle_varying(const struct etch_mesh_stage *stage,
                                const struct etch_assembly *assembly, const void *buffer,
                                uint8_t count, const uint16_t index[3]);

/* ---- the sink that rasterises textures ---------------------------------------------------------
 */

/* What draw/texture.h's perspective painters have in common. */
typedef void etch_perspective_painter(const struct etch_surface *s,
                                      const struct etch_texture_vertex *const v[3],
                                      const struct etch_texture *texture,
                                      const struct etch_perspective_kernels *kernels);

struct etch_texture_sink {
    struct etch_sink sink; /* give &it.sink to etch_assembly */
    const struct etch_surface *surface;
    const struct etch_texture *texture;
    etch_perspective_painter *painter;              /* draw/texture.h, with .. */
    const struct etch_perspective_kernels *kernels; /* .. kernels that fit it */
};

/* Fills in all members. Surface and texture stay the caller's. */
void etch_texture_sink_init(struct etch_texture_sink *sink, const struct etch_surface *surface,
                            const struct etch_texture *texture, etch_perspective_painter *painter,
                            const struct etch_perspective_kernels *kernels);

#endif
