/* raster/smooth_line.h: the rectangle of a smooth line; no part of the API. */
#ifndef ETCH_RASTER_SMOOTH_LINE_H
#define ETCH_RASTER_SMOOTH_LINE_H

#include "smooth_shapes.h"

/* Adds the edges, 4 at most, to `to`; none without a length or a width. */
void etch_smooth_line_edges(struct etch_smooth *to, struct etch_point_q8 a, struct etch_point_q8 b,
                            int32_t width);

#endif
