/* raster/round_rect.h: rectangles with rounded corners.
 *
 * The rectangle (x, y, w, h) whose corners are quarters of the disc (circle.h) of radius r, held to
 * 0 .. (min(w, h) - 1) / 2: with w = h = 2 r + 1 it is the disc itself, with r = 0 the rectangle.
 * Its outline is the pixels of it of which one of the four neighbours is outside. Every int16_t is
 * legal; w or h <= 0 draws nothing. Cost as ellipse.h.
 */
#ifndef ETCH_RASTER_ROUND_RECT_H
#define ETCH_RASTER_ROUND_RECT_H

#include "../base/paint.h"

/* The runs of the inside and the outline. */
void etch_round_rect_runs(const struct etch_surface *s, int16_t x, int16_t y, int16_t w, int16_t h,
                          int16_t r, const struct etch_paint *paint);

/* The runs of the outline, up to two a row (by bands, base/paint.h). */
void etch_round_rect_outline_runs(const struct etch_surface *s, int16_t x, int16_t y, int16_t w,
                                  int16_t h, int16_t r, const struct etch_paint *paint);

#endif
