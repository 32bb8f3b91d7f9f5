/* draw/setup_small.h: what the small triangle painters share; no part of the API. */
#ifndef ETCH_DRAW_SETUP_SMALL_H
#define ETCH_DRAW_SETUP_SMALL_H

#include "../raster/plane.h"
#include "../raster/plane_small.h"
#include "../raster/triangle_small.h"
#include "triangle_small.h"

struct etch_gouraud_paint;

/* The positions of v to p and the planes of their colours; false without area. */
bool etch_setup_small(struct etch_gouraud_paint *paint, struct etch_point_q8 p[3],
                      const struct etch_vertex *const v[3]);

#endif
