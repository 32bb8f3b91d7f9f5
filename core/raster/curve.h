/* raster/curve.h: quadratic and cubic Bezier curves as polylines of a stated flatness.
 *
 * A curve is cut at 2^k equal steps of its parameter, the least k that makes every chord flat
 * enough, which follows from the second differences of its control points:
 *
 *      quadratic   chord to curve <= |p0 - 2 p1 + p2| / 4^(k + 1)
 *      cubic       chord to curve <= 3 max(|p0 - 2 p1 + p2|, |p1 - 2 p2 + p3|) / 4^(k + 1)
 *
 * The points are the curve's own, exactly computed by forward differences and rounded half up to
 * 1/256 px, so the polyline is within flatness + 1/256 px of the curve everywhere; k depends on
 * the control points alone, and both ends are met exactly. Control points within -2^23 .. 2^23.
 * Source: the bound is that of linear interpolation, h^2 / 8 max |p''|, as used by R. F.
 * Riesenfeld, J. Lane, "A theoretical development for the computer generation and display of
 * piecewise polynomial surfaces", 1980; forward differences: S. Coons, 1967.
 */
#ifndef ETCH_RASTER_CURVE_H
#define ETCH_RASTER_CURVE_H

#include "line.h"
#include "polygon.h"

/* How far chords may be from the curve where a call does not ask: 1/8 px. */
#define ETCH_CURVE_FLATNESS_Q8 32

/* Takes the next point of a polyline. */
typedef void etch_curve_point(void *context, struct etch_point_q8 to);

/* Calls point(context, ..) for every point of the polyline but the first, which is p[0]: 2^k calls,
 * the last with p[2] or p[3]. Flatness is in 1/256 px, 1 .. 2^31 - 1, and less is taken as 1; k is
 * 13 at most. Cost: two (quadratic) or three (cubic) 64-bit sums a coordinate of a point. */
void etch_quadratic_flatten(const struct etch_point_q8 p[3], int32_t flatness_q8,
                            etch_curve_point *point, void *context);
void etch_cubic_flatten(const struct etch_point_q8 p[4], int32_t flatness_q8,
                        etch_curve_point *point, void *context);

/* k for second differences whose length is at most `length_q8`, of a quadratic; of a cubic, three
 * times that. */
uint8_t etch_curve_bits(uint32_t length_q8, int32_t flatness_q8);

/* Part of the contour of a polygon: the edges of the curve from p[0] to its last point. Straight
 * parts between curves are etch_polygon_add_edge. The curve needs room for up to 2^k edges. */
enum etch_status etch_polygon_add_quadratic(struct etch_polygon *polygon,
                                            const struct etch_point_q8 p[3], int32_t flatness_q8);
enum etch_status etch_polygon_add_cubic(struct etch_polygon *polygon,
                                        const struct etch_point_q8 p[4], int32_t flatness_q8);

/* One-pixel lines along the curve, whose control points are centres of pixels; every int16_t is
 * legal. The chords of flatness 1/8 px, their ends rounded to pixels, are drawn as etch_line_draw
 * does, each joint once; on curves of more than 32 chords every 32nd joint is written twice. */
void etch_quadratic_draw(const struct etch_surface *s, const struct etch_point p[3],
                         uint16_t color);
void etch_cubic_draw(const struct etch_surface *s, const struct etch_point p[4], uint16_t color);

#endif
