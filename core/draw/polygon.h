/* draw/polygon.h: polygons with holes in one colour. Which pixels: raster/polygon.h. */
#ifndef ETCH_DRAW_POLYGON_H
#define ETCH_DRAW_POLYGON_H

#include "../raster/polygon.h"

/* Fills the polygon of `contours` closed contours: the first has size[0] vertices, v[0] on, the
 * next size[1], ..; vertices are centres of pixels and every int16_t is legal. `color` is in the
 * surface's byte order; each pixel is written once. `edge` is the caller's for the call, with room
 * for as many edges as there are vertices. ETCH_ENOMEM, and nothing drawn, if that is too few. */
enum etch_status etch_polygon_fill_evenodd(const struct etch_surface *s, const struct etch_point *v,
                                           const uint16_t *size, uint16_t contours, uint16_t color,
                                           struct etch_polygon_edge *edge, uint16_t room);
enum etch_status etch_polygon_fill_nonzero(const struct etch_surface *s, const struct etch_point *v,
                                           const uint16_t *size, uint16_t contours, uint16_t color,
                                           struct etch_polygon_edge *edge, uint16_t room);

#endif
