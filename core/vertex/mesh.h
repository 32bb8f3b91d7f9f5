/* vertex/mesh.h: an indexed triangle mesh, constant, so that it can live in flash. */
#ifndef ETCH_VERTEX_MESH_H
#define ETCH_VERTEX_MESH_H

#include "../base/fixed.h"

struct etch_mesh {
    const int16_t *positions; /* x, y, z per vertex, in 2^-bits model units */
    const int8_t *normals;    /* x, y, z per vertex, length 127; NULL: the mesh has none */
    const uint8_t *colors;    /* r, g, b per vertex; NULL: white */
    const uint16_t *indices;  /* three per triangle, counter-clockwise seen from outside */
    uint16_t vertex_count;
    uint16_t triangle_count;
    uint16_t extent; /* largest |coordinate| in positions, 0 .. 32768; a small one (4095 or
                        less) lets vertices be transformed by 32-bit products */
    uint8_t bits;    /* fraction bits of the positions, 0 .. 15 */
};

/* All reads of mesh data go through these, so that a core whose constants need an instruction
 * of their own (AVR's flash) has one place to change. */

ETCH_INLINE void etch_mesh_position(const struct etch_mesh *mesh, uint16_t vertex, int16_t p[3])
{
    const int16_t *from = mesh->positions + (size_t)vertex * 3;

    p[0] = from[0];
    p[1] = from[1];
    p[2] = from[2];
}

/* Only for a mesh with normals. */
ETCH_INLINE void etch_mesh_normal(const struct etch_mesh *mesh, uint16_t vertex, int8_t n[3])
{
    const int8_t *from = mesh->normals + (size_t)vertex * 3;

    n[0] = from[0];
    n[1] = from[1];
    n[2] = from[2];
}

/* The vertex's own colour, white without colours. */
ETCH_INLINE void etch_mesh_color(const struct etch_mesh *mesh, uint16_t vertex, uint8_t rgb[3])
{
    if (mesh->colors == NULL) {
        rgb[0] = rgb[1] = rgb[2] = 255;
    } else {
        const uint8_t *from = mesh->colors + (size_t)vertex * 3;

        rgb[0] = from[0];
        rgb[1] = from[1];
        rgb[2] = from[2];
    }
}

ETCH_INLINE void etch_mesh_triangle(const struct etch_mesh *mesh, uint16_t triangle,
                                    uint16_t index[3])
{
    const uint16_t *from = mesh->indices + (size_t)triangle * 3;

    index[0] = from[0];
    index[1] = from[1];
    index[2] = from[2];
}

#endif
