/* draw/line_setup.h: what the line painters share; no part of the API. */
#ifndef ETCH_DRAW_LINE_SETUP_H
#define ETCH_DRAW_LINE_SETUP_H

#include "../fragment/gouraud.h"
#include "../raster/line_runs.h"
#include "../raster/line_steps.h"
#include "../raster/plane.h"
#include "line.h"

/* A line from pixel to pixel, and what of it is visible. */
struct line_setup {
    int16_t x0, y0, x1, y1;
    struct etch_line_steps steps;
};

ETCH_INLINE int16_t line_pixel(int32_t q8)
{
    return (int16_t)(q8 >> 8 > INT16_MAX ? INT16_MAX : q8 >> 8);
}

/* False if nothing is. */
ETCH_INLINE bool line_setup(struct line_setup *l, const struct etch_surface *s,
                            const struct etch_vertex *const v[2])
{
    l->x0 = line_pixel(v[0]->x_q8), l->y0 = line_pixel(v[0]->y_q8);
    l->x1 = line_pixel(v[1]->x_q8), l->y1 = line_pixel(v[1]->y_q8);
    return etch_line_steps_setup(&l->steps, &s->clip, l->x0, l->y0, l->x1, l->y1);
}

ETCH_INLINE void line_plane(struct etch_plane *plane, const struct line_setup *l, uint32_t v0,
                            uint32_t v1)
{
    etch_line_plane(plane, l->x0, l->y0, l->x1, l->y1, v0, v1);
}

ETCH_INLINE void line_depth(struct etch_plane *z, const struct line_setup *l,
                            const struct etch_vertex *const v[2])
{
    line_plane(z, l, etch_depth_q16(v[0]->z_q16), etch_depth_q16(v[1]->z_q16));
}

ETCH_INLINE void line_color(struct etch_gouraud_paint *p, const struct line_setup *l,
                            const struct etch_vertex *const v[2])
{
    line_plane(&p->r, l, etch_channel_q27(v[0]->r), etch_channel_q27(v[1]->r));
    line_plane(&p->g, l, etch_channel_q26(v[0]->g), etch_channel_q26(v[1]->g));
    line_plane(&p->b, l, etch_channel_q27(v[0]->b), etch_channel_q27(v[1]->b));
}

#endif
