/* draw/mesh_elements.h: the vertices of a mesh as points, lines, strips and fans.
 *
 *      const struct etch_elements elements = {indices, 24, mesh.vertex_count};
 *      struct etch_mesh_elements to;
 *
 *      etch_mesh_transform(&stage, &assembly.viewport, buffer);
 *      etch_mesh_elements_init(&to, etch_mesh_take_line, &stage, &assembly, buffer);
 *      etch_elements_line_loop(&elements, &to.sink);
 *
 * A kind (vertex/elements.h) says which vertices belong together, a taker what is made of them. The
 * mesh needs no indices of its own: triangle_count may be 0.
 */
#ifndef ETCH_DRAW_MESH_ELEMENTS_H
#define ETCH_DRAW_MESH_ELEMENTS_H

#include "../vertex/assembly_line.h"
#include "../vertex/elements.h"
#include "mesh.h"

typedef void etch_element_taker(struct etch_element_sink *sink, const uint16_t *index);

struct etch_mesh_elements {
    struct etch_element_sink sink; /* first; give it to a kind */
    const struct etch_mesh_stage *stage;
    const struct etch_assembly *assembly;
    const struct etch_mesh_vertex *buffer; /* of etch_mesh_transform */
};

/* Fills in all members; what is pointed to stays the caller's. The elements' limit must be at most
 * the mesh's vertex_count. */
void etch_mesh_elements_init(struct etch_mesh_elements *elements, etch_element_taker *taker,
                             const struct etch_mesh_stage *stage,
                             const struct etch_assembly *assembly,
                             const struct etch_mesh_vertex *buffer);

/* For etch_elements_points, for the kinds of lines, for the kinds of triangles: each hands its
 * primitives to the assembly's sink, as etch_assemble_point, _line and _triangle do with the clip
 * vertices. Those that are not clipped are taken from the buffer. */
etch_element_taker etch_mesh_take_point;
etch_element_taker etch_mesh_take_line;
etch_element_taker etch_mesh_take_triangle;

/* ---- a primitive function of your own, between assembly and clipping --------------------------
 */

/* Gets the clip-space vertices of a primitive and hands on what it likes, any number of
 * primitives of any kind, by etch_assemble_triangle, _line, _point or otherwise. */
struct etch_mesh_primitive;
typedef void etch_primitive_function(const struct etch_mesh_primitive *primitive,
                                     const struct etch_clip_vertex *v);

struct etch_mesh_primitive {
    struct etch_element_sink sink; /* first; give it to a kind */
    const struct etch_mesh_stage *stage;
    const struct etch_assembly *assembly;
    etch_primitive_function *function; /* its own data follow this struct */
    uint8_t size;                      /* vertices of a primitive, 1 .. 3: the kind's */
};

/* Fills in all members. Vertex functions run for every primitive; there is no buffer. */
void etch_mesh_primitive_init(struct etch_mesh_primitive *primitive,
                              etch_primitive_function *function, uint8_t size,
                              const struct etch_mesh_stage *stage,
                              const struct etch_assembly *assembly);

/* The same for the triangles of a mesh with indices: those of etch_mesh_assemble, in its order. */
void etch_mesh_primitive_triangles(struct etch_mesh_primitive *primitive);

#endif
