/* raster/line_dda.h: lines by a digital differential analyser, to be compared with line.h. */
#ifndef ETCH_RASTER_LINE_DDA_H
#define ETCH_RASTER_LINE_DDA_H

#include "line.h"

/* The line from (x0, y0) to (x1, y1): max(|dx|, |dy|) + 1 pixels, walked from the end with the
 * smaller major coordinate, so both directions give the same. Its slope is rounded to 1/65536,
 * and pixel k lies k times that further on, rounded half down. So it is off the true line by
 * 1/2 + k / 2^17 px at most, 1 px for the longest; it has etch_line_draw's pixel wherever the true
 * line is further than k / 2^17 px from the border of two pixels, and else that one's neighbour.
 * Lines of up to 241 px along x and y differ only where the true line passes exactly between two
 * pixels, in 0.2 % of the pixels of all such lines; lines of 1001 px in 0.3 %. Both ends are drawn,
 * clipping never moves a pixel, and every int16_t is legal.
 * One addition a pixel and no comparison; no division but four at the beginning. */
void etch_line_draw_dda(const struct etch_surface *s, int16_t x0, int16_t y0, int16_t x1,
                        int16_t y1, uint16_t color);

#endif
