/* vertex/fan.h: a projected polygon to triangles. Private to assembly.c and varying.c. */
#ifndef ETCH_VERTEX_FAN_H
#define ETCH_VERTEX_FAN_H

#include "assembly.h"

/* Culls and hands on the polygon ring[0 .. n-1], n = 0 or 3 .. ETCH_CLIP_MAX, as triangles: see
 * etch_assemble_fan. Vertices may be wider than an etch_vertex; ring is used up. */
void etch_fan_emit(const struct etch_assembly *assembly, const struct etch_vertex **ring,
                   uint8_t n);

#endif
