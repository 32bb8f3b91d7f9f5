/* draw/line_stipple.h: dotted and dashed lines of one pixel. Thick ones: raster/stroke.h. */
#ifndef ETCH_DRAW_LINE_STIPPLE_H
#define ETCH_DRAW_LINE_STIPPLE_H

#include "../base/paint.h"

/* Of the line from (x0, y0) to (x1, y1), the pixels of etch_line_draw (raster/line.h), hands those
 * to the paint whose bit is set: pixel k from (x0, y0) along the longer axis has bit 15 - k mod 16
 * of the pattern, so 0xFF00 begins with a dash of 8. Every int16_t is legal; clips and strips
 * change nothing. */
void etch_line_stipple_runs(const struct etch_surface *s, int16_t x0, int16_t y0, int16_t x1,
                            int16_t y1, uint16_t pattern, const struct etch_paint *paint);

/* The same in one colour, in the surface's byte order. */
void etch_line_stipple_draw(const struct etch_surface *s, int16_t x0, int16_t y0, int16_t x1,
                            int16_t y1, uint16_t pattern, uint16_t color);

#endif
