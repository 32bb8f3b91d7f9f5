/* draw/point.h: points of a size. Which pixels: raster/point_runs.h.
 *
 *      etch_point_fill(surface, x_q8, y_q8, size_q8, color, etch_point_runs_round);
 */
#ifndef ETCH_DRAW_POINT_H
#define ETCH_DRAW_POINT_H

#include "../base/sink.h"
#include "../raster/point_runs.h"

/* A point in one colour, in the surface's byte order; `runs` is etch_point_runs_square or _round.
 */
void etch_point_fill(const struct etch_surface *s, int32_t x_q8, int32_t y_q8, uint16_t size_q8,
                     uint16_t color, etch_point_runs *runs);

/* A point in colour and depth of v, the same at each of its pixels; any kernel of gouraud.h. */
void etch_point_paint(const struct etch_surface *s, const struct etch_vertex *v, uint16_t size_q8,
                      etch_point_runs *runs, etch_kernel *kernel);

#endif
