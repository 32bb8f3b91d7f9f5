/* fragment/flat_shader.h: the shader part of the flat kernels with depth. */
#ifndef ETCH_FRAGMENT_FLAT_SHADER_H
#define ETCH_FRAGMENT_FLAT_SHADER_H

#include "flat.h"
#include "template.h"

ETCH_INLINE void etch_flat_start(struct etch_fragment *f, const struct etch_paint *paint)
{
    f->v[0] = ((const struct etch_flat_depth_paint *)paint)->color;
}

ETCH_INLINE void etch_flat_step(struct etch_fragment *f, const struct etch_paint *paint)
{
    (void)f, (void)paint;
}

ETCH_INLINE uint16_t etch_flat_color(const struct etch_fragment *f, const struct etch_paint *paint)
{
    (void)paint;
    return (uint16_t)f->v[0];
}

static const struct etch_shader etch_flat_shader = {etch_flat_start, etch_flat_step,
                                                    etch_flat_color};

#endif
