/* raster/polygon_walk.h: the rows of a polygon; no part of the API. */
#ifndef ETCH_RASTER_POLYGON_WALK_H
#define ETCH_RASTER_POLYGON_WALK_H

#include "polygon.h"
#include "run_band.h"

/* Adds the runs of one row to the band: the edges that cross it, by rising x. */
typedef void etch_polygon_row(struct etch_run_band *band, int16_t y,
                              const struct etch_polygon_edge *edge);

void etch_polygon_walk(const struct etch_surface *surface, struct etch_polygon *p,
                       const struct etch_paint *paint, etch_polygon_row *row);

/* Sorts the edges by their first rows. */
void etch_polygon_sort(struct etch_polygon *p);

#endif
