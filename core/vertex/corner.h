/* vertex/corner.h: corners of a clipped triangle. Private to the clippers: clip.c, clip_volume.c,
 * clip_line_planes.c, assembly.c and varying.c.
 *
 * Everything happens in the triangle's own plane, in barycentric coordinates. A line there is
 * three numbers, the values of a linear function at the triangle's vertices: the signed distance
 * from a clip plane, or for an edge 0, 0 and 1. A corner is where two lines meet, its weights
 * their cross product. So a corner follows from the triangle and two planes alone, not from the
 * corners that were cut before, and on an edge it follows from that edge's two ends.
 *
 * Memory. A corner is kept as the names of its two lines, two bytes; lines and weights are
 * computed again wherever they are asked for. A polygon takes 18 bytes of stack in place of 342.
 */
#ifndef ETCH_VERTEX_CORNER_H
#define ETCH_VERTEX_CORNER_H

#include "clip.h"

/* Lines 0, 1, 2: the edges opposite to vertices 0, 1, 2; then the clip planes near, far and guard.
 */
enum {
    CORNER_EDGES = 3,
    CORNER_LINES = 9
};

struct corner_triangle {
    const struct etch_clip_vertex *v[3];
    uint8_t guard_x, guard_y; /* the sides are |x| <= 2^guard_x w, |y| <= 2^guard_y w */
};

struct corner {
    uint8_t line[2]; /* the two lines that meet here */
};

struct corner_line {
    int64_t at[3]; /* magnitude below 2^41 + 2^32; >= 0 is inside */
};

/* A weight of up to 90 bits: the sum of limb[i] * 2^(15 i). */
#define CORNER_LIMBS 6

struct corner_weights {
    uint16_t weight[3][CORNER_LIMBS]; /* of the triangle's vertices, of any common scale */
};

/* ---- one corner ------------------------------------------------------------------------------ */

/* The meeting point, inside the triangle, of lines a and b, exactly. */
void etch_corner_meet(struct corner_weights *weights, const struct corner_line *a,
                      const struct corner_line *b);

/* Whether a point is inside or on a line, exactly. */
bool etch_corner_is_inside(const struct corner_weights *weights, const struct corner_line *line);

/* The point as a vertex. Coordinates come from the exact sums by one rounding, scaled until
 * the largest takes 31 bits where they do not fit; colours are rounded from theirs. */
void etch_corner_resolve(struct etch_clip_vertex *out, const struct corner_weights *weights,
                         const struct etch_clip_vertex *const v[3]);

/* The value of a varying at the point, from those at the vertices: the exact one times
 * 2^fraction_bits (0 .. 31), rounded half up. A step a bit, about 32 + fraction_bits of them. */
int64_t etch_corner_value(const struct corner_weights *weights, const int32_t value[3],
                          uint8_t fraction_bits);

/* ---- corners of a triangle and its planes ---------------------------------------------------- */

/* Vertex i, where the edges opposite to the two others meet. */
struct corner etch_corner_vertex(uint8_t i);

/* Which of the triangle's vertices a corner is, or -1. */
int8_t etch_corner_which(const struct corner *corner);

/* A line by its name. */
void etch_corner_line(struct corner_line *line, const struct corner_triangle *t, uint8_t name);

/* The weights of a corner, exactly. */
void etch_corner_weights(struct corner_weights *weights, const struct corner_triangle *t,
                         const struct corner *corner);

/* Whether a corner is inside or on the plane whose line is given. A vertex costs a comparison. */
bool etch_corner_is_in_plane(const struct corner_triangle *t, const struct corner *corner,
                             const struct corner_line *plane);

/* A corner as a vertex: those of the triangle as they are, others resolved. */
void etch_corner_take(struct etch_clip_vertex *out, const struct corner_triangle *t,
                      const struct corner *corner);

/* The part of a triangle inside near, far and the sides. Returns its number of corners, 0 or
 * 3 .. ETCH_CLIP_MAX. */
uint8_t etch_corner_clip(const struct corner_triangle *t, struct corner corner[ETCH_CLIP_MAX]);

#endif
