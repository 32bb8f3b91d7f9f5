/* draw/setup_inverse.h: the plane of a floating depth; no part of the API. */
#ifndef ETCH_DRAW_SETUP_INVERSE_H
#define ETCH_DRAW_SETUP_INVERSE_H

#include "inverse.h"
#include "setup.h"

/* Sets *z to the plane of q 2^up with the greatest `up` that keeps it below 2^31 (or 0), and
 * returns it. */
uint8_t etch_setup_inverse(struct etch_plane *z, const struct etch_triangle *t,
                           const struct etch_basis *basis, const struct etch_vertex *const v[3]);

#endif
