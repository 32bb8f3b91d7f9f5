/* leaf/vector128/gouraud_rows.h: the loop of the two Gouraud kernels without depth; no part of the
 * API. */
#ifndef ETCH_LEAF_GOURAUD_ROWS_H
#define ETCH_LEAF_GOURAUD_ROWS_H

#include "gouraud_pixels.h"

ETCH_INLINE void gouraud_rows(const struct etch_surface *s, int16_t y0, const struct etch_run *runs,
                              uint8_t n, const struct etch_gouraud_paint *p, gouraud_join *join)
{
    const struct etch_run *const end = runs + n;
    const struct gouraud_vector by4 = gouraud_steps(p);
    const uintptr_t stride = (uintptr_t)s->stride * 2;
    uintptr_t row = etch_surface_row(s, s->pixels, y0);
    struct gouraud_vector left = {vector_ramp(etch_plane_at(&p->r, 0, y0), p->r.dx),
                                  vector_ramp(etch_plane_at(&p->g, 0, y0), p->g.dx),
                                  vector_ramp(etch_plane_at(&p->b, 0, y0), p->b.dx)};
    const struct gouraud_vector down = {vector_all(p->r.dy), vector_all(p->g.dy),
                                        vector_all(p->b.dy)};

    for (; runs != end; runs++) {
        const uint32_t x0 = (uint16_t)runs->x0, length = (uint16_t)runs->x1 - x0;

        if (length != 0) {
            const struct gouraud_vector c = {left.r + vector_all(etch_wrap_mul(x0, p->r.dx)),
                                             left.g + vector_all(etch_wrap_mul(x0, p->g.dx)),
                                             left.b + vector_all(etch_wrap_mul(x0, p->b.dx))};

            gouraud_walk((uint16_t *)etch_wrap_address_add(row, (uintptr_t)x0 * 2), length, c, &by4,
                         join);
        }
        gouraud_step(&left, &down);
        row = etch_wrap_address_add(row, stride);
    }
}

#endif
