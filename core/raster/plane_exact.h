/* raster/plane_exact.h: the numerators of the exact modes, a part of triangle set-up. */
#ifndef ETCH_RASTER_PLANE_EXACT_H
#define ETCH_RASTER_PLANE_EXACT_H

#include "../base/exact.h"
#include "triangle.h"

/* The plane of N, D times the varying that is value[i] at the caller's vertex i of `t`, D being
 * t->area; exact modulo 2^64 for every triangle. Seven products of 64 bits, no division. */
void etch_exact_plane_setup(struct etch_exact_plane *plane, const struct etch_triangle *t,
                            const uint32_t value[3]);

#endif
