/* raster/triangle_small.h: the edge walk for programs that count bytes: 460 on ARMv6-M with the
 * division it needs, where triangle.h takes 2,000. The pixels are the same, for every triangle
 * in range.
 */
#ifndef ETCH_RASTER_TRIANGLE_SMALL_H
#define ETCH_RASTER_TRIANGLE_SMALL_H

#include "triangle.h"

/* Hands the runs of the triangle v inside surface->clip to `paint`: those of etch_triangle_setup
 * and etch_triangle_runs. Needs no set-up: vertices in any order, zero area covers nothing.
 * Cost on ARMv6-M: some 400 instructions for each edge and block of 32 rows, then 17 per edge
 * and row; nothing for rows outside the clip, but rows whose columns miss it are walked. */
void etch_triangle_runs_small(const struct etch_surface *surface, const struct etch_point_q8 v[3],
                              const struct etch_paint *paint);

#endif
