/* fragment/texture_divide.h: coordinates in perspective at one pixel; no part of the API. */
#ifndef ETCH_FRAGMENT_TEXTURE_DIVIDE_H
#define ETCH_FRAGMENT_TEXTURE_DIVIDE_H

#include "texture_row.h"

/* What is linear on the screen, at one pixel. */
struct etch_texel_ratio {
    int32_t u, v, d; /* two numerators and their denominator */
};

ETCH_INLINE int32_t etch_ratio_at(const struct etch_plane *p, int32_t x, int32_t y)
{
    return (int32_t)etch_wrap_add(p->origin, etch_wrap_add(etch_wrap_mul(p->dx, (uint32_t)x),
                                                           etch_wrap_mul(p->dy, (uint32_t)y)));
}

/* Coordinates against the middles of the vertices', 1/4096 texel. */
struct etch_texel_offset {
    int32_t u, v;
};

/* The quotients rounded down, 100 instructions on ARMv6-M. Bound: see raster/texture_plane.h. */
void etch_texel_divide(struct etch_texel_offset *out, const struct etch_perspective_planes *c,
                       const struct etch_texel_ratio *at);

/* 16.16, held to the range of the vertices: a coordinate just below 0 is not to wrap to the far
 * texel. */
ETCH_INLINE uint32_t etch_texel_hold(const struct etch_perspective_axis *a, int32_t offset_q16)
{
    const int32_t held = offset_q16 < a->least  ? a->least
                         : offset_q16 > a->most ? a->most
                                                : offset_q16;

    return etch_wrap_add((uint32_t)held, a->middle);
}

ETCH_INLINE uint16_t etch_texel_held(const struct etch_perspective_paint *p, int32_t u_q16,
                                     int32_t v_q16)
{
    return etch_texel_at(&p->map, etch_wrap_up(etch_texel_hold(&p->coordinates.u, u_q16), 4),
                         etch_wrap_up(etch_texel_hold(&p->coordinates.v, v_q16), p->width_bits));
}

/* 1/4096 to 16.16, saturated: between triangles of a mesh that repeat a texture thousands of times
 * the last bit of a denominator can count for more than the range. */
ETCH_INLINE int32_t etch_texel_q16(int32_t offset)
{
    return offset > INT32_MAX >> 4      ? INT32_MAX
           : offset < -(INT32_MAX >> 4) ? -INT32_MAX
                                        : offset * 16;
}

#endif
