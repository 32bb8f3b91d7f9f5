/* raster/circle_small.h: circles for programs that count bytes. */
#ifndef ETCH_RASTER_CIRCLE_SMALL_H
#define ETCH_RASTER_CIRCLE_SMALL_H

#include "circle.h"

/* The pixels of etch_circle_draw (circle.h), one octant after the other: half the code, and half as
 * much again to execute. */
void etch_circle_draw_small(const struct etch_surface *s, int16_t cx, int16_t cy, int16_t r,
                            uint16_t color);

#endif
