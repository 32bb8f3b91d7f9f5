/* fragment/gouraud_small.c: interpolated colour in few bytes. See gouraud_small.h. */
#include "gouraud_small.h"

void etch_kernel_gouraud_small(const struct etch_surface *surface, int16_t y0,
                               const struct etch_run *runs, uint8_t n,
                               const struct etch_paint *paint)
{
    const struct etch_gouraud_paint *const p = (const struct etch_gouraud_paint *)paint;

    for (;;) {
        const int16_t x0 = runs->x0;
        uint16_t *pixel = (uint16_t *)(etch_surface_row(surface, surface->pixels, y0) +
                                       (uintptr_t)(uint16_t)x0 * 2);
        uint32_t r = etch_plane_at(&p->r, x0, y0), g = etch_plane_at(&p->g, x0, y0);
        uint32_t b = etch_plane_at(&p->b, x0, y0);

        for (int32_t left = runs->x1 - x0; left != 0; left--) {
            *pixel++ = (uint16_t)((r >> 27 << 6 | g >> 26) << 5 | b >> 27);
            r = etch_wrap_add(r, p->r.dx);
            g = etch_wrap_add(g, p->g.dx);
            b = etch_wrap_add(b, p->b.dx);
        }
        if (--n == 0)
            return;
        runs++, y0++;
    }
}
