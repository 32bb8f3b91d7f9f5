/* fragment/blend_gouraud_shader.h: the blender parts of the Gouraud kernels that blend. */
#ifndef ETCH_FRAGMENT_BLEND_GOURAUD_SHADER_H
#define ETCH_FRAGMENT_BLEND_GOURAUD_SHADER_H

#include "../base/rgb565.h"
#include "blend_channel.h"
#include "blend_fused.h"
#include "blend_template.h"

ETCH_INLINE void etch_gouraud_fade_start(struct etch_fragment *f, const struct etch_paint *paint)
{
    const struct etch_gouraud_blend_paint *p = (const struct etch_gouraud_blend_paint *)paint;

    f->v[0] = etch_plane_at(&p->gouraud.r, f->x, f->y);
    f->v[1] = etch_plane_at(&p->gouraud.g, f->x, f->y);
    f->v[2] = etch_plane_at(&p->gouraud.b, f->x, f->y);
    f->v[3] = p->alpha;
}

ETCH_INLINE void etch_gouraud_fade_step(struct etch_fragment *f, const struct etch_paint *paint)
{
    const struct etch_gouraud_blend_paint *p = (const struct etch_gouraud_blend_paint *)paint;

    f->v[0] = etch_wrap_add(f->v[0], p->gouraud.r.dx);
    f->v[1] = etch_wrap_add(f->v[1], p->gouraud.g.dx);
    f->v[2] = etch_wrap_add(f->v[2], p->gouraud.b.dx);
}

ETCH_INLINE void etch_gouraud_blend_start(struct etch_fragment *f, const struct etch_paint *paint)
{
    etch_gouraud_fade_start(f, paint);
    f->v[3] = etch_plane_at(&((const struct etch_gouraud_blend_paint *)paint)->a, f->x, f->y);
}

ETCH_INLINE void etch_gouraud_blend_step(struct etch_fragment *f, const struct etch_paint *paint)
{
    etch_gouraud_fade_step(f, paint);
    f->v[3] = etch_wrap_add(f->v[3], ((const struct etch_gouraud_blend_paint *)paint)->a.dx);
}

ETCH_INLINE uint16_t etch_gouraud_mix(const struct etch_fragment *f, uint32_t alpha, uint16_t pixel)
{
    const uint32_t r = etch_chunk_channel(f->v[0], UINT32_C(1) << 26, ETCH_CHUNK_RED_MAX);
    const uint32_t g = etch_chunk_channel(f->v[1], UINT32_C(1) << 25, ETCH_CHUNK_GREEN_MAX);
    const uint32_t b = etch_chunk_channel(f->v[2], UINT32_C(1) << 26, ETCH_CHUNK_RED_MAX);

    return (uint16_t)((etch_blend_mix(r, etch_pixel_red(pixel), alpha, 11) << 6 |
                       etch_blend_mix(g, etch_pixel_green(pixel), alpha, 10))
                          << 5 |
                      etch_blend_mix(b, etch_pixel_blue(pixel), alpha, 11));
}

ETCH_INLINE uint16_t etch_gouraud_fade_color(const struct etch_fragment *f,
                                             const struct etch_paint *paint, uint16_t pixel)
{
    (void)paint;
    return etch_gouraud_mix(f, f->v[3], pixel);
}

ETCH_INLINE uint16_t etch_gouraud_fade_color_swapped(const struct etch_fragment *f,
                                                     const struct etch_paint *paint, uint16_t pixel)
{
    return etch_rgb565_swap(etch_gouraud_fade_color(f, paint, etch_rgb565_swap(pixel)));
}

ETCH_INLINE uint16_t etch_gouraud_blend_color(const struct etch_fragment *f,
                                              const struct etch_paint *paint, uint16_t pixel)
{
    (void)paint;
    return etch_gouraud_mix(f, etch_chunk_alpha(f->v[3]), pixel);
}

ETCH_INLINE uint16_t etch_gouraud_blend_color_swapped(const struct etch_fragment *f,
                                                      const struct etch_paint *paint,
                                                      uint16_t pixel)
{
    return etch_rgb565_swap(etch_gouraud_blend_color(f, paint, etch_rgb565_swap(pixel)));
}

#endif
