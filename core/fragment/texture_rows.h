/* fragment/texture_rows.h: the affine kernels with depth; no part of the API. */
#ifndef ETCH_FRAGMENT_TEXTURE_ROWS_H
#define ETCH_FRAGMENT_TEXTURE_ROWS_H

#include "texture_row.h"

/* Depth first: it finds the pixels that pass, run by run, and only they have texels. */
ETCH_INLINE void etch_texture_depth_rows(const struct etch_surface *surface, int16_t y0,
                                         const struct etch_run *runs, uint8_t n,
                                         const struct etch_texture_paint *p,
                                         etch_depth_test *passes)
{
    const struct etch_run *const last = runs + n;
    const uintptr_t stride = (uintptr_t)surface->stride * 2;
    const uintptr_t to_pixel = etch_wrap_address_sub((uintptr_t)surface->pixels,
                                                     (uintptr_t)surface->depth);
    uintptr_t row = etch_surface_row(surface, surface->depth, y0);

    for (int16_t y = y0; runs != last; runs++, y++, row = etch_wrap_address_add(row, stride)) {
        uint16_t *stored = (uint16_t *)etch_wrap_address_add(row, (uintptr_t)runs->x0 * 2);
        const uint16_t *const end = stored + (runs->x1 - runs->x0);
        uint32_t z = etch_plane_at(&p->z, runs->x0, y);

        while ((stored = etch_depth_scan(stored, end, &z, p->z.dx, passes)) != end) {
            uint16_t *const first = stored;
            const int16_t x = (int16_t)(runs->x1 - (end - stored));
            const struct etch_texel_walk walk = {etch_plane_at(&p->u, x, y),
                                                 etch_plane_at(&p->v, x, y), p->u.dx, p->v.dx};

            stored = etch_depth_write(stored, end, &z, p->z.dx, passes);
            etch_texel_row((uint16_t *)etch_wrap_address_add((uintptr_t)first, to_pixel),
                           (uint32_t)(stored - first), &walk, &p->map);
        }
    }
}

/* Defines the kernel `name`. */
#define ETCH_TEXTURE_KERNEL(name, passes)                                                          \
    void name(const struct etch_surface *surface, int16_t y0, const struct etch_run *runs,         \
              uint8_t n, const struct etch_paint *paint)                                           \
    {                                                                                              \
        etch_texture_depth_rows(surface, y0, runs, n, (const struct etch_texture_paint *)paint,    \
                                passes);                                                           \
    }

#endif
