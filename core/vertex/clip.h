/* vertex/clip.h: a triangle in clip space to a convex polygon inside the planes.
 *
 * Sutherland-Hodgman: a pipeline of planes, near, far, then the four guard planes (viewport.h).
 * Each edge is cut from its inside to its outside end, and a cut on an edge of the triangle is
 * always computed from the edge's two ends, exactly, whatever was cut before: neighbours that
 * share the edge get the same vertex bit for bit.
 *
 * Precision. A cut vertex is homogeneous, so its scale is free: it is kept as 31-bit numbers
 * relative to its largest coordinate, rounded once from the exact combination of the ends. After
 * projection it lies within 1/64 px of the exact cut, for every input. Its colour is within
 * 1/2 + 1/64 of the exact one on an edge of the triangle, and within one more for each further
 * plane inside.
 * Source: I. Sutherland, G. Hodgman, "Reentrant polygon clipping", 1974.
 */
#ifndef ETCH_VERTEX_CLIP_H
#define ETCH_VERTEX_CLIP_H

#include "viewport.h"

/* Most vertices that six planes leave of a triangle. */
#define ETCH_CLIP_MAX 9

/* Clips v against near, far and the guard planes of `viewport` and writes the polygon, in the
 * order of v, to out (room for ETCH_CLIP_MAX). Returns its number of vertices, 0 or 3 ..
 * ETCH_CLIP_MAX. Each has w > 0 and can be projected; x, y, z, w of new vertices have a scale of
 * their own (only their ratios have a meaning). Every input is legal, w <= 0 and the
 * degenerate included. About 1 KB of stack. */
uint8_t etch_clip_triangle(const struct etch_viewport *viewport,
                           const struct etch_clip_vertex v[3],
                           struct etch_clip_vertex out[ETCH_CLIP_MAX]);

#endif
