/* raster/rect.h: rectangles to runs, and their outlines. */
#ifndef ETCH_RASTER_RECT_H
#define ETCH_RASTER_RECT_H

#include "../base/paint.h"

/* The runs of `rect` inside surface->clip. */
void etch_rect_runs(const struct etch_surface *s, struct etch_rect rect,
                    const struct etch_paint *paint);

/* The outline of the rectangle (x, y, w, h): w * h pixels less the inside, each once; w or
 * h <= 0 draws nothing. */
void etch_rect_draw(const struct etch_surface *s, int16_t x, int16_t y, int16_t w, int16_t h,
                    uint16_t color);

#endif
