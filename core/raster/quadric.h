/* raster/quadric.h: conic sections to runs: ellipses in any turn, parabolas, hyperbolas, and the
 * half-planes and stripes that they degenerate to. */
#ifndef ETCH_RASTER_QUADRIC_H
#define ETCH_RASTER_QUADRIC_H

#include "../base/paint.h"

/* The pixels where a x^2 + b x y + c y^2 + d x + e y + f < 0, x and y being columns and rows. All
 * int16_t x and y are exact: with the ranges below no sum reaches 2^63. For a curve that is given
 * to fractions of a pixel, multiply all coefficients. */
struct etch_quadric {
    int32_t a, b, c; /* -2^30 .. 2^30 */
    int64_t d, e;    /* -2^44 .. 2^44 */
    int64_t f;       /* -2^61 .. 2^61 */
};

/* ETCH_EINVAL if a coefficient is out of its range. */
enum etch_status etch_quadric_check(const struct etch_quadric *q);

/* Hands the runs inside surface->clip to the paint, at most two a row, each pixel once. The
 * coefficients must be in range. Cost: a row is scanned by 16 pixels at a time where F cannot
 * change sign, and pixel by pixel elsewhere, two 64-bit sums each.
 * Source: forward differences, after V. Pratt, "Techniques for conic splines", 1985. */
void etch_quadric_runs(const struct etch_surface *surface, const struct etch_quadric *q,
                       const struct etch_paint *paint);

#endif
