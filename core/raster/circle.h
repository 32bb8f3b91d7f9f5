/* raster/circle.h: midpoint circles and discs.
 *
 * The outline is the midpoint circle: in each octant the pixel nearest to the true circle,
 * 8-fold symmetric, each pixel once. r = 0 is one pixel, r = 1 four, r < 0 none. The disc is
 * every pixel on or inside that outline. Every int16_t centre and radius.
 * Source: J. R. Van Aken, "An efficient ellipse-drawing algorithm", 1984 (midpoint test).
 */
#ifndef ETCH_RASTER_CIRCLE_H
#define ETCH_RASTER_CIRCLE_H

#include "../base/paint.h"

/* The outline of radius r round pixel (cx, cy), flat colour. */
void etch_circle_draw(const struct etch_surface *s, int16_t cx, int16_t cy, int16_t r,
                      uint16_t color);

/* The runs of the disc. */
void etch_circle_runs(const struct etch_surface *s, int16_t cx, int16_t cy, int16_t r,
                      const struct etch_paint *paint);

#endif
