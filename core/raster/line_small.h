/* raster/line_small.h: lines for programs that count bytes. */
#ifndef ETCH_RASTER_LINE_SMALL_H
#define ETCH_RASTER_LINE_SMALL_H

#include "line.h"

/* The pixels of etch_line_draw (line.h), clipped as exactly and at a cost that is as much
 * proportional to what is visible; brings its own division. */
void etch_line_draw_small(const struct etch_surface *s, int16_t x0, int16_t y0, int16_t x1,
                          int16_t y1, uint16_t color);

#endif
