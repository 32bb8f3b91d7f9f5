/* draw/setup.h: what the triangle painters share; no part of the API. */
#ifndef ETCH_DRAW_SETUP_H
#define ETCH_DRAW_SETUP_H

#include "../raster/plane.h"
#include "triangle.h"

/* Sets up the edges; false if nothing of the triangle can be visible. */
ETCH_INLINE bool setup_visible(struct etch_triangle *t, const struct etch_surface *s,
                               const struct etch_vertex *const v[3])
{
    const struct etch_point_q8 p[3] = {
        {v[0]->x_q8, v[0]->y_q8}, {v[1]->x_q8, v[1]->y_q8}, {v[2]->x_q8, v[2]->y_q8}};

    return etch_triangle_setup(t, p) && etch_triangle_is_visible(t, s->clip);
}

ETCH_INLINE void setup_depth(struct etch_plane *z, const struct etch_triangle *t,
                             const struct etch_vertex *const v[3])
{
    const uint32_t value[3] = {etch_depth_q16(v[0]->z_q16), etch_depth_q16(v[1]->z_q16),
                               etch_depth_q16(v[2]->z_q16)};

    etch_plane_setup(z, t, value);
}

ETCH_INLINE void setup_color(struct etch_plane *r, struct etch_plane *g, struct etch_plane *b,
                             const struct etch_triangle *t, const struct etch_vertex *const v[3])
{
    const uint32_t red[3] = {etch_channel_q27(v[0]->r), etch_channel_q27(v[1]->r),
                             etch_channel_q27(v[2]->r)};
    const uint32_t green[3] = {etch_channel_q26(v[0]->g), etch_channel_q26(v[1]->g),
                               etch_channel_q26(v[2]->g)};
    const uint32_t blue[3] = {etch_channel_q27(v[0]->b), etch_channel_q27(v[1]->b),
                              etch_channel_q27(v[2]->b)};

    etch_plane_setup(r, t, red);
    etch_plane_setup(g, t, green);
    etch_plane_setup(b, t, blue);
}

#endif
