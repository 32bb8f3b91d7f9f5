/* fragment/gouraud_shader.h: the shader part of the Gouraud kernels. */
#ifndef ETCH_FRAGMENT_GOURAUD_SHADER_H
#define ETCH_FRAGMENT_GOURAUD_SHADER_H

#include "../base/rgb565.h"
#include "gouraud.h"
#include "template.h"

ETCH_INLINE void etch_gouraud_start(struct etch_fragment *f, const struct etch_paint *paint)
{
    const struct etch_gouraud_paint *p = (const struct etch_gouraud_paint *)paint;

    f->v[0] = etch_plane_at(&p->r, f->x, f->y);
    f->v[1] = etch_plane_at(&p->g, f->x, f->y);
    f->v[2] = etch_plane_at(&p->b, f->x, f->y);
}

ETCH_INLINE void etch_gouraud_step(struct etch_fragment *f, const struct etch_paint *paint)
{
    const struct etch_gouraud_paint *p = (const struct etch_gouraud_paint *)paint;

    f->v[0] = etch_wrap_add(f->v[0], p->r.dx);
    f->v[1] = etch_wrap_add(f->v[1], p->g.dx);
    f->v[2] = etch_wrap_add(f->v[2], p->b.dx);
}

/* 5.27, 6.26 and 5.27 pack by shifts alone: the integer bits are the channel. */
ETCH_INLINE uint16_t etch_gouraud_color(const struct etch_fragment *f,
                                        const struct etch_paint *paint)
{
    (void)paint;
    return (uint16_t)((f->v[0] >> 27 << 6 | f->v[1] >> 26) << 5 | f->v[2] >> 27);
}

ETCH_INLINE uint16_t etch_gouraud_color_swapped(const struct etch_fragment *f,
                                                const struct etch_paint *paint)
{
    return etch_rgb565_swap(etch_gouraud_color(f, paint));
}

static const struct etch_shader etch_gouraud_shader = {etch_gouraud_start, etch_gouraud_step,
                                                       etch_gouraud_color};
static const struct etch_shader etch_gouraud_swapped_shader = {
    etch_gouraud_start, etch_gouraud_step, etch_gouraud_color_swapped};

#endif
