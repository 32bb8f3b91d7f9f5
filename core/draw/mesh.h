/* draw/mesh.h: meshes and clip-space triangles to pixels.
 *
 *      vertices once:       etch_mesh_transform:  vertex function -> outcode -> project -> buffer
 *      triangles, n times:  etch_mesh_assemble:   buffer -> reject -> clip -> cull -> sink
 *
 * The two halves stand alone: run the first once a frame and the second once a strip, with the
 * same buffer. A single clip-space triangle goes through etch_assemble_triangle
 * (vertex/assembly.h) into the same sink.
 */
#ifndef ETCH_DRAW_MESH_H
#define ETCH_DRAW_MESH_H

#include "../vertex/assembly.h"
#include "../vertex/light.h"
#include "../vertex/mesh.h"
#include "triangle.h"

/* ---- the sink that rasterises --------------------------------------------------------- */

struct etch_raster_sink {
    struct etch_sink sink; /* give &raster.sink to etch_assembly */
    const struct etch_surface *surface;
    etch_triangle_painter *painter; /* draw/triangle.h, with .. */
    etch_kernel *kernel;            /* .. a kernel that fits it */
};

/* Fills in all members. The surface stays the caller's and may be changed between calls (the
 * next strip). */
void etch_raster_sink_init(struct etch_raster_sink *raster, const struct etch_surface *surface,
                           etch_triangle_painter *painter, etch_kernel *kernel);

/* ---- the vertex stage ------------------------------------------------------------------- */

struct etch_mesh_stage;

/* The programmable vertex: sets all of *out for vertex `index` (< vertex_count) of the mesh.
 * Called once a vertex, and again for the vertices of triangles that are clipped: it must give
 * the same result both times. Users put their own data behind etch_mesh_stage as its first
 * member. */
typedef void etch_vertex_function(const struct etch_mesh_stage *stage, uint16_t index,
                                  struct etch_clip_vertex *out);

struct etch_mesh_stage {
    const struct etch_mesh *mesh;
    etch_vertex_function *vertex;         /* one of those below, or a user's */
    struct etch_transform transform;      /* by etch_transform_init, from mesh->bits, extent */
    const struct etch_lighting *lighting; /* read by etch_vertex_lit only */
    uint8_t color[4];                     /* r, g, b, a; multiplies the mesh's colours */
};

/* Position transformed, colour = mesh color * stage color / 255. */
etch_vertex_function etch_vertex_plain;

/* The same colour, lit. A mesh without normals gets the ambient light only. */
etch_vertex_function etch_vertex_lit;

/* Prepares a stage: `transform` from the model-to-clip matrix, colour opaque white. The mesh and
 * the lighting stay the caller's and must stay valid while the stage is used; lighting is NULL
 * where the vertex function does not read it (etch_vertex_lit does). */
void etch_mesh_stage_init(struct etch_mesh_stage *stage, const struct etch_mesh *mesh,
                          const struct etch_matrix *model_to_clip, etch_vertex_function *vertex,
                          const struct etch_lighting *lighting);

/* ---- drawing ---------------------------------------------------------------------------- */

/* What is kept of a vertex: 20 bytes. */
struct etch_mesh_vertex {
    struct etch_vertex v; /* not set where out has a bit of ETCH_OUT_CLIP */
    uint8_t out;          /* outcode */
};

/* Runs the vertex function, outcode and projection for every vertex of the mesh. `buffer` is
 * the caller's, with room for mesh->vertex_count. */
void etch_mesh_transform(const struct etch_mesh_stage *stage, const struct etch_viewport *viewport,
                         struct etch_mesh_vertex *buffer);

/* The same for vertices first .. end - 1, at most vertex_count, into their places of the same
 * buffer: a share of the work for one of several workers. */
void etch_mesh_transform_range(const struct etch_mesh_stage *stage,
                               const struct etch_viewport *viewport,
                               struct etch_mesh_vertex *buffer, uint16_t first, uint16_t end);

/* Hands the visible triangles of the transformed mesh to assembly->sink, in mesh order. Reads
 * the buffer; clipped triangles run their vertex functions again. A triangle with an index
 * that is not below vertex_count is skipped: nothing outside the mesh is ever read. */
void etch_mesh_assemble(const struct etch_mesh_stage *stage, const struct etch_assembly *assembly,
                        const struct etch_mesh_vertex *buffer);

/* Both. ETCH_ENOMEM, and nothing drawn, if `room`, the vertices that the buffer holds, is less
 * than mesh->vertex_count. */
enum etch_status etch_mesh_draw(const struct etch_mesh_stage *stage,
                                const struct etch_assembly *assembly,
                                struct etch_mesh_vertex *buffer, size_t room);

#endif
