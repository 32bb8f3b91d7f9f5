/* fragment/texture_span.c: pixels of a row with affine texture. Called by the affine kernels with
 * depth. See texture_row.h. */
#include "texture_row.h"

void etch_texel_span(uint16_t *pixel, int32_t x, uint32_t n, int32_t y,
                     const struct etch_paint *paint)
{
    const struct etch_texture_paint *const p = (const struct etch_texture_paint *)paint;
    const struct etch_texel_walk walk = {etch_plane_at(&p->u, (int16_t)x, (int16_t)y),
                                         etch_plane_at(&p->v, (int16_t)x, (int16_t)y), p->u.dx,
                                         p->v.dx};

    etch_texel_row(pixel, n, &walk, &p->map);
}
