/* raster/plane_small.h: exact plane equations for programs that count bytes. */
#ifndef ETCH_RASTER_PLANE_SMALL_H
#define ETCH_RASTER_PLANE_SMALL_H

#include "triangle.h"

/* The plane through value[i] at v[i], the same numbers as etch_plane_setup (plane.h) gives for
 * the same triangle, which keeps the precise bounds wherever the vertices are. Needs no set-up;
 * the order of the vertices changes nothing. False, and *plane as it was, if v has no area.
 * 300 bytes and some 6,000 instructions on ARMv6-M. */
bool etch_plane_setup_small(struct etch_plane *plane, const struct etch_point_q8 v[3],
                            const uint32_t value[3]);

#endif
