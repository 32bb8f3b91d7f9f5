/* fragment/gouraud_less_small.c: interpolated colour where nearer than the depth plane, in few
 * bytes. See gouraud_small.h. */
#include "gouraud_small.h"

void etch_kernel_gouraud_less_small(const struct etch_surface *surface, int16_t y0,
                                    const struct etch_run *runs, uint8_t n,
                                    const struct etch_paint *paint)
{
    const struct etch_gouraud_paint *p = (const struct etch_gouraud_paint *)paint;
    const uintptr_t to_pixel = etch_wrap_address_sub((uintptr_t)surface->pixels,
                                                     (uintptr_t)surface->depth);

    for (; n != 0; n--, runs++, y0++) {
        int16_t x = runs->x0;
        uint16_t *stored = (uint16_t *)(etch_surface_row(surface, surface->depth, y0) +
                                        (uintptr_t)(uint16_t)x * 2);
        uint32_t z = etch_plane_at(&p->z, x, y0);

        for (; x != runs->x1; x++, stored++) {
            const uint16_t depth = (uint16_t)(z >> 16);

            if (depth < *stored) {
                *stored = depth;
                *(uint16_t *)etch_wrap_address_add(
                    (uintptr_t)stored,
                    to_pixel) = (uint16_t)((etch_plane_at(&p->r, x, y0) >> 27 << 6 |
                                            etch_plane_at(&p->g, x, y0) >> 26)
                                               << 5 |
                                           etch_plane_at(&p->b, x, y0) >> 27);
            }
            z = etch_wrap_add(z, p->z.dx);
        }
    }
}
