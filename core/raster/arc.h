/* raster/arc.h: rings, arcs and pies.
 *
 * Radii are those of the circle and the disc of circle.h round pixel (cx, cy). A ring is the disc
 * of radius `outer` less the disc of radius `inner`: with inner < 0 it is the whole disc, with
 * inner >= outer nothing; rings that follow each other share no pixel and leave none out.
 *
 * Angles are in 65536ths of a turn, clockwise from the right. A part begins at `from` and goes on
 * for `sweep`: 0 draws nothing, 65536 or more is the full turn. A pixel is in it iff its direction
 * from the centre is at or after the first ray and before the last, rays being the vectors of
 * base/trig.h, told by cross products, exactly; the centre pixel counts as the direction 0. So
 * parts that follow each other share no pixel and leave none out either.
 *
 * Outlines are the pixels of which one of the four neighbours is outside. Every int16_t is legal.
 * Cost: as ellipse.h for each radius, and for the rays four 64-bit divisions by shift and subtract
 * a call and two sums a row. Up to three runs a row, by bands (base/paint.h).
 */
#ifndef ETCH_RASTER_ARC_H
#define ETCH_RASTER_ARC_H

#include "../base/paint.h"

/* The part of the circle (the one-pixel outline) of radius r. */
void etch_arc_line_runs(const struct etch_surface *s, int16_t cx, int16_t cy, int16_t r,
                        uint16_t from, uint32_t sweep, const struct etch_paint *paint);

/* The part of a ring: a thick arc; inner < 0 makes it a pie. */
void etch_arc_runs(const struct etch_surface *s, int16_t cx, int16_t cy, int16_t outer,
                   int16_t inner, uint16_t from, uint32_t sweep, const struct etch_paint *paint);
void etch_arc_outline_runs(const struct etch_surface *s, int16_t cx, int16_t cy, int16_t outer,
                           int16_t inner, uint16_t from, uint32_t sweep,
                           const struct etch_paint *paint);

/* The whole ring. */
void etch_ring_runs(const struct etch_surface *s, int16_t cx, int16_t cy, int16_t outer,
                    int16_t inner, const struct etch_paint *paint);
void etch_ring_outline_runs(const struct etch_surface *s, int16_t cx, int16_t cy, int16_t outer,
                            int16_t inner, const struct etch_paint *paint);

#endif
