/* fragment/texture_exact.h: the shader part of the kernels that divide at every pixel. */
#ifndef ETCH_FRAGMENT_TEXTURE_EXACT_H
#define ETCH_FRAGMENT_TEXTURE_EXACT_H

#include "texture_divide.h"
#include "texture_row.h"

ETCH_INLINE void etch_perspective_start(struct etch_fragment *f, const struct etch_paint *paint)
{
    (void)f, (void)paint;
}

ETCH_INLINE void etch_perspective_step(struct etch_fragment *f, const struct etch_paint *paint)
{
    (void)paint;
    f->x++;
}

ETCH_INLINE uint16_t etch_perspective_color(const struct etch_fragment *f,
                                            const struct etch_paint *paint)
{
    const struct etch_perspective_paint *p = (const struct etch_perspective_paint *)paint;
    const struct etch_perspective_planes *const c = &p->coordinates;
    const struct etch_texel_ratio at = {etch_ratio_at(&c->u.numerator, f->x, f->y),
                                        etch_ratio_at(&c->v.numerator, f->x, f->y),
                                        etch_ratio_at(&c->denominator, f->x, f->y)};
    struct etch_texel_offset offset;

    etch_texel_divide(&offset, c, &at);
    return etch_texel_held(p, etch_texel_q16(offset.u), etch_texel_q16(offset.v));
}

static const struct etch_shader etch_perspective_shader = {
    etch_perspective_start, etch_perspective_step, etch_perspective_color};

#endif
