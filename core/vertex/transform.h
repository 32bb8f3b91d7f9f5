/* vertex/transform.h: model space to clip space.
 *
 * A model position is three int16_t p, each p / 2^bits model units (`bits` is the mesh's).
 * The result is
 *      floor((m[i][0] px + m[i][1] py + m[i][2] pz + m[i][3] 2^bits) / 2^bits + 1/2)
 * in 16.16: one rounding a coordinate, from the exact sum. What leaves 16.16 saturates, which
 * moves the vertex; keep |clip coordinates| below 32768.
 *
 * Where no sum can leave 32 bits, known from the matrix and the mesh's extent, a product is one
 * 32-bit multiplication (twelve a vertex) and the results are the same.
 */
#ifndef ETCH_VERTEX_TRANSFORM_H
#define ETCH_VERTEX_TRANSFORM_H

#include "matrix.h"

/* A vertex between the vertex function and clipping. */
struct etch_clip_vertex {
    etch_q16 x, y, z, w; /* visible where -w <= x, y, z <= w; y up; every value is legal */
    uint8_t r, g, b, a;  /* 0 .. 255 */
};

struct etch_transform {
    struct etch_matrix matrix; /* model to clip space */
    uint8_t bits;              /* fraction bits of the positions, 0 .. 15 */
    bool narrow;               /* no sum leaves 32 bits */
};

/* Prepares a transform of positions with |coordinate| <= extent (0 .. 32768). bits > 15 counts
 * as 15. */
void etch_transform_init(struct etch_transform *t, const struct etch_matrix *matrix, uint8_t bits,
                         uint16_t extent);

/* Sets out->x, y, z, w from position p and leaves its colour. With coordinates beyond the
 * extent of etch_transform_init the result is unspecified (but nothing else happens). */
void etch_transform_position(const struct etch_transform *t, const int16_t p[3],
                             struct etch_clip_vertex *out);

#endif
