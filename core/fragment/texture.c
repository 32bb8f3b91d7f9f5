/* fragment/texture.c: affine texture. See texture.h. */
#include "texture_row.h"

void etch_kernel_texture(const struct etch_surface *surface, int16_t y0,
                         const struct etch_run *runs, uint8_t n, const struct etch_paint *paint)
{
    const struct etch_texture_paint *const p = (const struct etch_texture_paint *)paint;
    const struct etch_texel_map map = p->map;
    const struct etch_run *const end = runs + n;
    const uintptr_t stride = (uintptr_t)surface->stride * 2;
    uintptr_t row = etch_surface_row(surface, surface->pixels, y0);
    uint32_t u0 = etch_plane_at(&p->u, 0, y0), v0 = etch_plane_at(&p->v, 0, y0);

    for (; runs != end; runs++, row = etch_wrap_address_add(row, stride)) {
        const uint32_t x = (uint32_t)(int32_t)runs->x0;
        const struct etch_texel_walk walk = {etch_wrap_add(u0, etch_wrap_mul(p->u.dx, x)),
                                             etch_wrap_add(v0, etch_wrap_mul(p->v.dx, x)), p->u.dx,
                                             p->v.dx};

        etch_texel_row((uint16_t *)etch_wrap_address_add(row, (uintptr_t)x * 2),
                       (uint32_t)(runs->x1 - runs->x0), &walk, &map);
        u0 = etch_wrap_add(u0, p->u.dy);
        v0 = etch_wrap_add(v0, p->v.dy);
    }
}
