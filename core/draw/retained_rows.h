/* draw/retained_rows.h: which triangles of a mesh a strip has to look at.
 *
 * etch_mesh_assemble (mesh.h) rejects and culls every triangle of the mesh for every strip. Done
 * once a frame, what is left is a list of the visible ones with their rows, 10 bytes each:
 *
 *      once a frame:     etch_mesh_transform, then etch_mesh_rows:  buffer -> list
 *      for every strip:  etch_mesh_assemble_rows:  list -> rows of the strip -> assembly->sink
 *
 * The sink gets the triangles of etch_mesh_assemble that have rows in the strip, in its order. To
 * keep their set-up too, see retained.h.
 */
#ifndef ETCH_DRAW_RETAINED_ROWS_H
#define ETCH_DRAW_RETAINED_ROWS_H

#include "mesh.h"

struct etch_mesh_row_range {
    uint16_t triangle;          /* of the mesh */
    int16_t y0, y1;             /* rows of the frame, half-open; all if it is to be clipped */
    int16_t group_y0, group_y1; /* of ETCH_MESH_ROWS_GROUP triangles, in the first of them */
};

#define ETCH_MESH_ROWS_GROUP 8

/* Lists the visible triangles of the transformed mesh. Returns how many there are; only the first
 * `room` are written, so with more than that use etch_mesh_assemble. */
uint16_t etch_mesh_rows(const struct etch_mesh_stage *stage, const struct etch_assembly *assembly,
                        const struct etch_mesh_vertex *buffer, struct etch_mesh_row_range *list,
                        uint16_t room);

/* The same for triangles first .. end - 1, at most triangle_count: a share of the work for one of
 * several workers, who have a list each. Assembling the lists in the order of their triangles gives
 * the order of the mesh. */
uint16_t etch_mesh_rows_range(const struct etch_mesh_stage *stage,
                              const struct etch_assembly *assembly,
                              const struct etch_mesh_vertex *buffer,
                              struct etch_mesh_row_range *list, uint16_t room, uint16_t first,
                              uint16_t end);

/* Hands those of the `count` listed that touch rows y0 .. y1 - 1 to assembly->sink. Cost on
 * ARMv6-M: 9 instructions for each of the others, or for eight of them. */
void etch_mesh_assemble_rows(const struct etch_mesh_stage *stage,
                             const struct etch_assembly *assembly,
                             const struct etch_mesh_vertex *buffer,
                             const struct etch_mesh_row_range *list, uint16_t count, int16_t y0,
                             int16_t y1);

#endif
