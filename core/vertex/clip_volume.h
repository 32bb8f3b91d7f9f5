/* vertex/clip_volume.h: triangles against all six planes of the volume -w <= x, y, z <= w.
 *
 * The alternative to etch_clip_triangle (clip.h), which clips by near, far and guard planes and
 * leaves the sides to the rasteriser's scissor. What comes out lies wholly in the viewport: for a
 * sink that has no scissor, for feedback, or to bound the coordinates of what is drawn. By the
 * scissor is quicker and exact: here a cut at a side is rounded to 1/256 px when it is projected,
 * which turns its edge a little, and the polygon has more triangles.
 *
 * Six planes stand in a row, each a stage that hands corners on to the next as they come, without
 * a polygon between them. Corners are exact and follow from the triangle and two planes alone
 * (clip.h), so shared edges stay shared, near and far are cut as by etch_clip_triangle bit for bit,
 * and no pixel near a shared edge is lost or drawn twice.
 *
 * Drawn pixels. Nothing is drawn outside the viewport; inside, a pixel is as the scissor leaves it
 * if its centre is further than 1/128 px from each edge of the triangle (1/64 px where near or far
 * cut it): a cut and the ends of its edge are each off by 1/512 px on both axes. One in some
 * 2000 of the pixels on edges differs so. None would need corners finer than 1/256 px: the line
 * through two vertices meets other points of that grid only by chance. Where pixels must be the
 * same, bit for bit, use etch_assemble_triangle and the scissor.
 * Source: I. Sutherland, G. Hodgman, "Reentrant polygon clipping", 1974.
 */
#ifndef ETCH_VERTEX_CLIP_VOLUME_H
#define ETCH_VERTEX_CLIP_VOLUME_H

#include "assembly.h"

/* Clips v and writes the polygon, in the order of v, to out (room for ETCH_CLIP_MAX). Returns its
 * number of vertices, 0 or 3 .. ETCH_CLIP_MAX, as etch_clip_triangle does. Some 550 bytes of
 * stack. */
uint8_t etch_clip_triangle_volume(const struct etch_clip_vertex v[3],
                                  struct etch_clip_vertex out[ETCH_CLIP_MAX]);

/* etch_assemble_triangle (assembly.h) with it, in place of near, far and guard planes. */
void etch_assemble_triangle_volume(const struct etch_assembly *assembly,
                                   const struct etch_clip_vertex v[3]);

#endif
