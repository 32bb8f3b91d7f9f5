/* raster/alpha_plane.h: the plane of a triangle's alpha. */
#ifndef ETCH_RASTER_ALPHA_PLANE_H
#define ETCH_RASTER_ALPHA_PLANE_H

#include "basis.h"

/* Alpha of the caller's vertices as 8.23 + 1/128, room below 0 and above 255 for what planes err
 * by: less than 2^-12 of a unit if the triangle is near (`basis` not NULL), else (x + y + 1) /
 * 2^24. Equal values stay exactly equal. fragment/stage.h has the way back. */
void etch_alpha_plane(struct etch_plane *a, const struct etch_triangle *t,
                      const struct etch_basis *basis, const struct etch_vertex *const v[3]);

#endif
