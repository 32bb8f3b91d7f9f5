/* vertex/corner.h: corners of a clipped triangle. Private to clip.c and
 * varying.c.
 *
 * Everything happens in the triangle's own plane, in barycentric coordinates. A line there is
 * three numbers, the values of a linear function at the triangle's vertices: the signed distance
 * from a clip plane, or for an edge 0, 0 and 1. A corner is where two lines meet, its weights
 * their cross product. So a corner follows from the triangle and two planes alone, not from the
 * corners that were cut before, and on an edge it follows from that edge's two ends.
 */
#ifndef ETCH_VERTEX_CORNER_H
#define ETCH_VERTEX_CORNER_H

#include "clip.h"

/* Lines 0, 1, 2: the edges opposite to vertices 0, 1, 2; then the clip planes near, far and guard. */
enum {
    CORNER_EDGES = 3,
    CORNER_LINES = 9
};

struct corner_line {
    int64_t at[3]; /* magnitude below 2^41 + 2^32; >= 0 is inside */
};

/* A weight of up to 90 bits: the sum of limb[i] * 2^(15 i). */
#define CORNER_LIMBS 6

struct corner {
    uint16_t weight[3][CORNER_LIMBS]; /* of the triangle's vertices, of any common scale */
    uint8_t line[2];                  /* the two lines that meet here */
};

/* Vertex i, where the lines opposite to the two others meet. */
void etch_corner_vertex(struct corner *corner, uint8_t i);

/* The meeting point, inside the triangle, of lines a and b, exactly. */
void etch_corner_meet(struct corner *corner, const struct corner_line *lines, uint8_t a, uint8_t b);

/* Whether a corner is inside or on a line, exactly. */
bool etch_corner_is_inside(const struct corner *corner, const struct corner_line *line);

/* The corner as a vertex. Coordinates come from the exact sums by one rounding, scaled until
 * the largest takes 31 bits where they do not fit; colours are rounded from theirs. */
void etch_corner_resolve(struct etch_clip_vertex *out, const struct corner *corner,
                         const struct etch_clip_vertex triangle[3]);

/* The value of a varying at the corner, from those at the vertices: the exact one times
 * 2^fraction_bits (0 .. 31), rounded half up. A step a bit, about 32 + fraction_bits of them. */
int64_t etch_corner_value(const struct corner *corner, const int32_t value[3],
                          uint8_t fraction_bits);

/* Of a corner of etch_corner_clip: which of the triangle's vertices it is, or -1. */
int8_t etch_corner_which(const struct corner *corner);

struct corner_polygon {
    uint8_t n;
    struct corner corner[ETCH_CLIP_MAX];
};

struct corner_work {
    struct corner_line lines[CORNER_LINES];
    struct corner_polygon polygon[2];
};

/* The part of a triangle inside near, far and guard planes, with 0 or 3 .. ETCH_CLIP_MAX corners.
 * It stands in *work, the caller's scratch. */
const struct corner_polygon *etch_corner_clip(struct corner_work *work,
                                              const struct etch_viewport *viewport,
                                              const struct etch_clip_vertex v[3]);

#endif
