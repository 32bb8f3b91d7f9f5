/* raster/halfspace.h: triangles by three edge functions over their bounding box.
 *
 * The textbook alternative to the edge walk of triangle.h, with the same pixels: every pixel of the
 * box is tested, so its cost grows with the box and not with the triangle. It is here to be
 * measured against, and because it is short. Source: J. Pineda, "A parallel algorithm for polygon
 * rasterization", 1988.
 */
#ifndef ETCH_RASTER_HALFSPACE_H
#define ETCH_RASTER_HALFSPACE_H

#include "triangle.h"

/* Hands the runs of `t` inside surface->clip to `paint`: the pixels of etch_triangle_runs, for
 * every triangle in range. No division: six 64-bit products a triangle, three 64-bit additions a
 * row of the box and three for each of its pixels up to the right end of the row's run. */
void etch_triangle_runs_halfspace(const struct etch_surface *surface, const struct etch_triangle *t,
                                  const struct etch_paint *paint);

#endif
