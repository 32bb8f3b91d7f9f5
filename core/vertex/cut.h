/* vertex/cut.h: the corner where a plane cuts an edge. Private to the vertex stage's clipping.
 *
 * A corner is homogeneous: v = scale * (x, y, z, w) with a positive scale that is its own. Only
 * the weights of colours need the scale; it is kept as a small float.
 */
#ifndef ETCH_VERTEX_CUT_H
#define ETCH_VERTEX_CUT_H

#include "viewport.h"

/* mantissa * 2^exponent; mantissa in 2^31 .. 2^32 - 1, or 0. */
struct cut_scale {
    uint32_t mantissa;
    int16_t exponent;
};

struct cut_corner {
    int32_t v[4]; /* x, y, z, w */
    struct cut_scale scale;
    uint8_t rgba[4];
    uint8_t ends; /* bit i: vertex i of the triangle has a part in it */
};

/* A vertex of the triangle, and back. */
void etch_cut_corner(struct cut_corner *corner, const struct etch_clip_vertex *v, uint8_t ends);
void etch_cut_vertex(struct etch_clip_vertex *v, const struct cut_corner *corner);

/* The point of the edge where a distance that is `inside` >= 0 at `in` and `outside` < 0 at
 * `out` is zero; both at most 2^43 in magnitude. *cut may not be one of the ends. */
void etch_cut_edge(struct cut_corner *cut, const struct cut_corner *in, int64_t inside,
                   const struct cut_corner *out, int64_t outside);

#endif
