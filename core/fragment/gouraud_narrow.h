/* fragment/gouraud_narrow.h: interpolated colour with depth where runs are short; no part of the
 * API.
 *
 * The triangles of a mesh have a few pixels a row. To find the spans that pass and start colours
 * for each then costs more than to step colours along with the depth, at every pixel. As in
 * gouraud_rows.h the planes walk from run to run as one cursor. The pixels are those of
 * depth_rows.h with etch_gouraud_span.
 */
#ifndef ETCH_FRAGMENT_GOURAUD_NARROW_H
#define ETCH_FRAGMENT_GOURAUD_NARROW_H

#include "gouraud_rows.h"
#include "gouraud_span.h"

etch_kernel etch_gouraud_narrow_less, etch_gouraud_narrow_less_swapped;
etch_kernel etch_gouraud_narrow_lequal, etch_gouraud_narrow_lequal_swapped;

/* Whether a block is better drawn so: by the run in its middle. */
ETCH_INLINE bool gouraud_is_narrow(const struct etch_run *runs, uint8_t n)
{
    const struct etch_run *const middle = runs + n / 2;

    return middle->x1 - middle->x0 < 16;
}

ETCH_INLINE void gouraud_narrow(const struct etch_surface *s, int16_t y0,
                                const struct etch_run *runs, uint8_t n,
                                const struct etch_gouraud_paint *p, etch_depth_test *passes,
                                etch_gouraud_pack *pack)
{
    const struct etch_run *const end = runs + n;
    const uintptr_t stride = (uintptr_t)s->stride * 2;
    const uintptr_t to_pixel = etch_wrap_address_sub((uintptr_t)s->pixels, (uintptr_t)s->depth);
    uintptr_t row = etch_surface_row(s, s->depth, y0);
    const uint32_t dz = p->z.dx, dr = p->r.dx, dg = p->g.dx, db = p->b.dx;
    uint32_t r = etch_plane_at(&p->r, 0, y0), g = etch_plane_at(&p->g, 0, y0);
    uint32_t b = etch_plane_at(&p->b, 0, y0), z = etch_plane_at(&p->z, 0, y0), x = 0;

    ETCH_ASSERT(s->depth != NULL);
    do {
        const uint32_t x0 = (uint16_t)runs->x0, x1 = (uint16_t)runs->x1;

        if (x0 != x1) { /* a fifth of the rows of small triangles have no pixel */
            const uint32_t right = etch_wrap_sub(x0, x);
            uintptr_t at = etch_wrap_address_add(row, (uintptr_t)x0 * 2);
            const uintptr_t stop = etch_wrap_address_add(row, (uintptr_t)x1 * 2);

            z = etch_wrap_add(z, etch_wrap_mul(right, dz));
            r = etch_wrap_add(r, etch_wrap_mul(right, dr));
            g = etch_wrap_add(g, etch_wrap_mul(right, dg));
            b = etch_wrap_add(b, etch_wrap_mul(right, db));
            for (; at != stop; at += 2) {
                const uint16_t depth = (uint16_t)(z >> 16);

                if (passes(depth, *(const uint16_t *)at)) {
                    *(uint16_t *)at = depth;
                    *(uint16_t *)etch_wrap_address_add(at, to_pixel) = pack(r, g, b);
                }
                z = etch_wrap_add(z, dz);
                r = etch_wrap_add(r, dr), g = etch_wrap_add(g, dg), b = etch_wrap_add(b, db);
            }
            x = x1;
        }
        z = etch_wrap_add(z, p->z.dy), r = etch_wrap_add(r, p->r.dy);
        g = etch_wrap_add(g, p->g.dy), b = etch_wrap_add(b, p->b.dy);
        row = etch_wrap_address_add(row, stride);
    } while (++runs != end);
}

#endif
