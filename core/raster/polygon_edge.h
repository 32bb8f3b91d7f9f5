/* raster/polygon_edge.h: an edge that is walked row by row; no part of the API.
 *
 * With xa, ya the upper end and y_c = 256 y + 128 a row of centres, the first pixel at or right of
 * the edge is ceil(M / dy), M = ceil(((xa - 128) dy + (y_c - ya) dx) / 256), as raster/triangle.c
 * derives; x and e = x dy - M, 0 <= e < dy, step by quotient and remainder of dx / dy. So polygons
 * and triangles that share an edge share its pixels.
 */
#ifndef ETCH_RASTER_POLYGON_EDGE_H
#define ETCH_RASTER_POLYGON_EDGE_H

#include "polygon.h"

/* The edge between a and b, put on its first row. False if it crosses no row of centres, or none
 * above row 32767, which no surface has. Ends within -2^23 .. 2^23. */
bool etch_polygon_edge_setup(struct etch_polygon_edge *g, struct etch_point_q8 a,
                             struct etch_point_q8 b);

/* Moves it from its row to row y of y0 .. y1 - 1, up or down. */
void etch_polygon_edge_move(struct etch_polygon_edge *g, int16_t y);

/* A row down. */
ETCH_INLINE void etch_polygon_edge_step(struct etch_polygon_edge *g)
{
    g->x += g->quotient;
    g->e -= g->remainder;
    if (g->e < 0)
        g->e += g->dy, g->x++;
    g->y++;
}

#endif
