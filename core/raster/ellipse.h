/* raster/ellipse.h: ellipses with level axes.
 *
 * The ellipse of radii rx and ry round pixel (cx, cy) is every pixel from which a step of half a
 * pixel towards the centre, across or down and not beyond it, leads into x^2 / rx^2 + y^2 / ry^2
 * <= 1. So it reaches rx to either side and ry up and down, with rx == ry it is the disc of
 * circle.h, and with a radius of 0 a straight line. Its outline is those pixels of which one of the
 * four neighbours is outside: 8-connected however thin it is, and with rx == ry the circle. Every
 * int16_t centre and radius; below 0 draws nothing.
 *
 * Each row is an interval, found once at the top of the clip and then moved by sums within the
 * clip's columns: what is not seen costs nothing. 15 steps of 64-bit products a call; a row takes
 * four 64-bit sums, and four for each column that its edge moves by.
 * Source: the midpoint test of J. R. Van Aken, "An efficient ellipse-drawing algorithm", 1984, in
 * both directions at every pixel.
 */
#ifndef ETCH_RASTER_ELLIPSE_H
#define ETCH_RASTER_ELLIPSE_H

#include "../base/paint.h"

/* The runs of the ellipse. */
void etch_ellipse_runs(const struct etch_surface *s, int16_t cx, int16_t cy, int16_t rx, int16_t ry,
                       const struct etch_paint *paint);

/* The runs of its outline, up to two a row (by bands, base/paint.h). */
void etch_ellipse_outline_runs(const struct etch_surface *s, int16_t cx, int16_t cy, int16_t rx,
                               int16_t ry, const struct etch_paint *paint);

#endif
