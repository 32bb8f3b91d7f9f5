/* raster/line.h: one-pixel lines, flat colour, written in walking order.
 *
 * A line has max(|dx|, |dy|) + 1 pixels, both ends drawn, nearest pixel on the minor axis. It
 * is computed from the end with the smaller major coordinate, and on a tie stays on that side
 * (Bresenham's decision steps at D > 0), so both directions give the same pixels. Clipping
 * never moves a pixel, and the walk starts at the clip edge: cost is proportional to what is
 * visible. Every int16_t coordinate is legal.
 * Source: J. E. Bresenham, "Algorithm for computer control of a digital plotter", 1965.
 */
#ifndef ETCH_RASTER_LINE_H
#define ETCH_RASTER_LINE_H

#include "../base/surface.h"

/* The line from (x0, y0) to (x1, y1). */
void etch_line_draw(const struct etch_surface *s, int16_t x0, int16_t y0, int16_t x1, int16_t y1,
                    uint16_t color);

/* The pixel (x, y). */
void etch_point_draw(const struct etch_surface *s, int16_t x, int16_t y, uint16_t color);

/* w pixels from (x, y) to the right, h pixels from (x, y) down; w, h <= 0 draw nothing. */
void etch_hline_draw(const struct etch_surface *s, int16_t x, int16_t y, int16_t w, uint16_t color);
void etch_vline_draw(const struct etch_surface *s, int16_t x, int16_t y, int16_t h, uint16_t color);

struct etch_point {
    int16_t x, y;
};

/* The lines p[0] p[1], p[1] p[2], .. with each joint written once (a joint is the pixel where
 * one line ends and the next begins; crossings are written again). n = 1 is one pixel, n = 0
 * nothing. A last point equal to the first closes the outline, its joint written once too. */
void etch_polyline_draw(const struct etch_surface *s, const struct etch_point *p, size_t n,
                        uint16_t color);

/* The same, closed: the last line leads from p[n - 1] back to p[0]. */
void etch_polygon_draw(const struct etch_surface *s, const struct etch_point *p, size_t n,
                       uint16_t color);

#endif
