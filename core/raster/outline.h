/* raster/outline.h: contours of round shapes and thick lines, edge by edge, for polygons
 * (polygon.h) and smooth shapes (smooth.h) alike.
 *
 *      struct etch_outline o = {etch_outline_smooth, &smooth};    or etch_outline_polygon, &polygon
 *
 * Fill with the non-zero rule: parts may overlap, and are counted once. Arcs become chords that
 * stay within 1/64 px of them up to a radius of 2048 px, corners being rounded to 1/256 px: the
 * cover of a pixel differs by less than 1/32 for that. All coordinates and radii in 1/256 px; what
 * leaves -2^23 .. 2^23 is held there. Failures (ETCH_ENOMEM) are kept by the polygon, which then
 * draws nothing.
 */
#ifndef ETCH_RASTER_OUTLINE_H
#define ETCH_RASTER_OUTLINE_H

#include "smooth.h"

struct etch_outline {
    void (*edge)(void *shape, struct etch_point_q8 a, struct etch_point_q8 b);
    void *shape;
};

void etch_outline_smooth(void *smooth, struct etch_point_q8 a, struct etch_point_q8 b);
void etch_outline_polygon(void *polygon, struct etch_point_q8 a, struct etch_point_q8 b);

/* The chords of a full turn of this radius: a power of two, 8 .. 1024. */
uint16_t etch_outline_chords(int32_t radius_q8);

/* The ellipse round `centre`; rx, ry 0 .. 2^23, else nothing. `hole` winds the other way: a ring is
 * an ellipse and a hole. etch_outline_chords(the larger radius) edges. */
void etch_outline_ellipse(const struct etch_outline *o, struct etch_point_q8 centre, int32_t rx,
                          int32_t ry, bool hole);

/* The part of a ring between the radii outer and inner (0: a pie) from the angle `from` on, `sweep`
 * 65536ths of a turn clockwise: 0 adds nothing, 65536 or more the full ring. Up to twice the chords
 * and two. */
void etch_outline_arc(const struct etch_outline *o, struct etch_point_q8 centre, int32_t outer,
                      int32_t inner, uint16_t from, uint32_t sweep);

/* The rectangle between two corners, its own rounded by `radius`, at most half of either side. The
 * chords and four. */
void etch_outline_round_rect(const struct etch_outline *o, struct etch_point_q8 a,
                             struct etch_point_q8 b, int32_t radius);

#endif
