/* raster/weights.h: set-up of the weights of a triangle's vertices in perspective. */
#ifndef ETCH_RASTER_WEIGHTS_H
#define ETCH_RASTER_WEIGHTS_H

#include "../base/weights.h"
#include "triangle.h"

/* w[i] > 0 is the distance of the caller's vertex i, in any unit; 0 counts as 1. Depends on the
 * triangle alone, not on the order of its vertices. Edges are exact, 1/w within 2^-27 of itself. */
void etch_weights_setup(struct etch_weights *weights, const struct etch_triangle *t,
                        const uint32_t w[3]);

#endif
