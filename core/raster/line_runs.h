/* raster/line_runs.h: lines for any paint, and the varyings along them.
 *
 * The pixels are those of etch_line_draw (line.h), handed over as runs from top to bottom, so every
 * kernel that paints triangles paints lines. A varying is linear along the major axis, from the
 * value at one end's pixel to that at the other's: a plane (base/paint.h) that does not change
 * along the minor axis.
 */
#ifndef ETCH_RASTER_LINE_RUNS_H
#define ETCH_RASTER_LINE_RUNS_H

#include "../base/paint.h"

/* Hands the runs of the line from (x0, y0) to (x1, y1) inside surface->clip to `paint`. Every
 * int16_t is legal, both directions give the same, and the cost is proportional to the visible
 * rows: five 32-bit divisions a line at most, then a few additions a row, besides the kernel's. */
void etch_line_runs(const struct etch_surface *surface, int16_t x0, int16_t y0, int16_t x1,
                    int16_t y1, const struct etch_paint *paint);

/* The plane of a varying that is v0 at the pixel (x0, y0) and v1 at (x1, y1), in any format. k
 * pixels from the end with the smaller major coordinate it errs by at most k / 2 units, 32767 in
 * all; there it is exact. Both directions give the same plane, and equal values that value
 * everywhere. A line of one pixel has the mean, rounded down. One 32-bit division. */
void etch_line_plane(struct etch_plane *plane, int16_t x0, int16_t y0, int16_t x1, int16_t y1,
                     uint32_t v0, uint32_t v1);

#endif
