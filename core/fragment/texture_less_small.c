/* fragment/texture_less_small.c: texture in perspective, a divide every pixel, where nearer than
 * the depth plane, in few bytes. See texture_small.h. */
#include "texture_divide.h"
#include "texture_small.h"

static int32_t at(const struct etch_plane *p, int32_t x, int32_t y)
{
    return etch_ratio_at(p, x, y);
}

static uint32_t held(const struct etch_perspective_axis *a, int32_t offset)
{
    return etch_texel_hold(a, etch_texel_q16(offset));
}

static uint16_t texel(const struct etch_perspective_paint *p, int32_t x, int32_t y)
{
    const struct etch_perspective_planes *const c = &p->coordinates;
    const struct etch_texel_ratio ratio = {at(&c->u.numerator, x, y), at(&c->v.numerator, x, y),
                                           at(&c->denominator, x, y)};
    struct etch_texel_offset offset;

    etch_texel_divide(&offset, c, &ratio);
    return etch_texel_at(&p->map, etch_wrap_up(held(&c->u, offset.u), 4),
                         etch_wrap_up(held(&c->v, offset.v), p->width_bits));
}

void etch_kernel_perspective_less_small(const struct etch_surface *surface, int16_t y0,
                                        const struct etch_run *runs, uint8_t n,
                                        const struct etch_paint *paint)
{
    const struct etch_perspective_paint *const p = (const struct etch_perspective_paint *)paint;

    for (; n != 0; n--, runs++, y0++) {
        for (int16_t x = runs->x0; x != runs->x1; x++) {
            const size_t i = etch_surface_index(surface, x, y0);
            const uint16_t depth = (uint16_t)((uint32_t)at(&p->z, x, y0) >> 16);

            if (depth < surface->depth[i]) {
                surface->depth[i] = depth;
                surface->pixels[i] = texel(p, x, y0);
            }
        }
    }
}
