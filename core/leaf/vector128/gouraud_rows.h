/* leaf/vector128/gouraud_rows.h: the loop of the two Gouraud kernels without depth; no part of the
 * API. */
#ifndef ETCH_LEAF_GOURAUD_ROWS_H
#define ETCH_LEAF_GOURAUD_ROWS_H

#include "gouraud_pixels.h"

ETCH_INLINE void gouraud_rows(const struct etch_surface *s, int16_t y0, const struct etch_run *runs,
                              uint8_t n, const struct etch_gouraud_paint *p, gouraud_join *join)
{
    const struct etch_run *const end = runs + n;
    struct gouraud_planes planes = gouraud_planes(p, y0);
    const struct gouraud_vector ramp = gouraud_ramp(planes.dx);
    const struct gouraud_vector by4 = gouraud_spread(planes.dx << 2);
    const uintptr_t stride = (uintptr_t)s->stride * 2;
    uintptr_t row = etch_surface_row(s, s->pixels, y0);

    for (; runs != end; runs++) {
        const uint32_t x0 = (uint16_t)runs->x0, length = (uint16_t)runs->x1 - x0;

        if (length != 0) {
            struct gouraud_vector c = gouraud_spread(gouraud_planes_at(&planes, x0));

            gouraud_step(&c, &ramp);
            gouraud_walk((uint16_t *)etch_wrap_address_add(row, (uintptr_t)x0 * 2), length, c, &by4,
                         join);
        }
        planes.left += planes.dy;
        row = etch_wrap_address_add(row, stride);
    }
}

#endif
