/* vertex/clip.h: a triangle in clip space to a convex polygon inside the planes.
 *
 * Sutherland-Hodgman: a pipeline of planes, near, far, then the four guard planes (viewport.h).
 * A corner is computed from the triangle and the two planes that meet in it, exactly, whatever
 * was cut before; on an edge it depends on that edge's two ends alone. So neighbours that share
 * an edge get the same corners bit for bit, and what is inside is decided without rounding.
 *
 * Precision. A corner is homogeneous, so its scale is free: its coordinates are the exact ones,
 * rounded once where they need more than 31 bits. Projected it lies within 1/64 px of the exact
 * cut before the rounding to 1/256 px, for every input (1/512 px where the viewport is at least
 * 128 px wide and high). Its colour is a whole number of 0 .. 255, as a vertex's is, within
 * 1/2 + 1/64 of the exact one: so up to a 1/255 of full may show between a triangle that was cut
 * and its uncut neighbour, and a gradient that is cut in many small steps keeps only these. Source:
 * I. Sutherland, G. Hodgman, "Reentrant polygon clipping", 1974.
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
 * degenerate included. Some 460 bytes of stack. Meant for the few triangles that cross a plane: it
 * costs many times the set-up of one that does not. */
uint8_t etch_clip_triangle(const struct etch_viewport *viewport, const struct etch_clip_vertex v[3],
                           struct etch_clip_vertex out[ETCH_CLIP_MAX]);

#endif
