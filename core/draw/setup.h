/* draw/setup.h: what the triangle painters share; no part of the API. */
#ifndef ETCH_DRAW_SETUP_H
#define ETCH_DRAW_SETUP_H

#include "../raster/basis.h"
#include "../fragment/gouraud.h"
#include "triangle.h"

/* Sets up the edges; false if nothing of the triangle can be visible. */
ETCH_INLINE bool setup_visible(struct etch_triangle *t, const struct etch_surface *s,
                               const struct etch_vertex *const v[3])
{
    const struct etch_point_q8 p[3] = {
        {v[0]->x_q8, v[0]->y_q8}, {v[1]->x_q8, v[1]->y_q8}, {v[2]->x_q8, v[2]->y_q8}};

    return etch_triangle_setup(t, p) && etch_triangle_is_visible(t, &s->clip);
}

/* The planes by the basis, or exactly where there is none or it refuses. */
ETCH_INLINE void setup_depth(struct etch_plane *z, const struct etch_triangle *t,
                             const struct etch_basis *basis, const struct etch_vertex *const v[3])
{
    if (basis == NULL || !etch_basis_depth(basis, t, v, z))
        etch_plane_depth(t, v, z);
}

ETCH_INLINE void setup_color(struct etch_gouraud_paint *p, const struct etch_triangle *t,
                             const struct etch_basis *basis, const struct etch_vertex *const v[3])
{
    if (basis == NULL || !etch_basis_color(basis, t, v, &p->r, &p->g, &p->b))
        etch_plane_color(t, v, &p->r, &p->g, &p->b);
}

#endif
