/* fragment/blend_flat_shader.h: the blender part of the flat kernels that blend. */
#ifndef ETCH_FRAGMENT_BLEND_FLAT_SHADER_H
#define ETCH_FRAGMENT_BLEND_FLAT_SHADER_H

#include "../base/rgb565.h"
#include "blend_fused.h"
#include "blend_template.h"

ETCH_INLINE void etch_flat_blend_start(struct etch_fragment *f, const struct etch_paint *paint)
{
    const struct etch_flat_blend_paint *p = (const struct etch_flat_blend_paint *)paint;

    f->v[0] = p->red_blue;
    f->v[1] = p->green;
    f->v[2] = p->keep;
}

ETCH_INLINE void etch_flat_blend_step(struct etch_fragment *f, const struct etch_paint *paint)
{
    (void)f, (void)paint;
}

/* With x = least + 1 + d keep <= 16192, (x + x / 256) / 256 is (x - 1) / 255 rounded down. Red and
 * blue stay below 2^13 each, so one word holds both. */
ETCH_INLINE uint16_t etch_flat_blend_color(const struct etch_fragment *f,
                                           const struct etch_paint *paint, uint16_t pixel)
{
    const uint32_t d = pixel;
    uint32_t rb = (d >> 11 | (d & 31) << 16) * f->v[2] + f->v[0];
    uint32_t g = (d >> 5 & 63) * f->v[2] + f->v[1];

    (void)paint;
    rb += rb >> 8 & UINT32_C(0xFF00FF);
    g += g >> 8;
    return (uint16_t)((rb & 0x1F00) << 3 | g >> 8 << 5 | rb >> 24);
}

ETCH_INLINE uint16_t etch_flat_blend_color_swapped(const struct etch_fragment *f,
                                                   const struct etch_paint *paint, uint16_t pixel)
{
    return etch_rgb565_swap(etch_flat_blend_color(f, paint, etch_rgb565_swap(pixel)));
}

static const struct etch_blender etch_flat_blender = {etch_flat_blend_start, etch_flat_blend_step,
                                                      etch_flat_blend_color};
static const struct etch_blender etch_flat_blender_swapped = {
    etch_flat_blend_start, etch_flat_blend_step, etch_flat_blend_color_swapped};

#endif
