/* raster/point_runs.h: points of a size, as squares or discs, for any paint.
 *
 * The centre is in 1/256 px as a triangle's vertices are (x, y = -2^23 .. 2^23; pixel (i, j) has
 * its centre at (256 i + 128, 256 j + 128)), the size is the side or the diameter in 1/256 px.
 */
#ifndef ETCH_RASTER_POINT_RUNS_H
#define ETCH_RASTER_POINT_RUNS_H

#include "../base/paint.h"

/* What both have in common, so that a caller can hold either. */
typedef void etch_point_runs(const struct etch_surface *surface, int32_t x_q8, int32_t y_q8,
                             uint16_t size_q8, const struct etch_paint *paint);

/* The square, as OpenGL's points: a pixel is covered iff its centre is inside, or on the top or
 * left side, of the square of that size round (x, y). So a size of n px covers n x n pixels
 * wherever its centre is, as two triangles would. Size 0 covers nothing. */
etch_point_runs etch_point_runs_square;

/* The disc: a pixel is covered iff its centre is inside or on the circle of that diameter. Round
 * a pixel's centre a size of 0 covers that pixel, elsewhere nothing. A 32-bit square root of 16
 * steps for each visible row. */
etch_point_runs etch_point_runs_round;

#endif
