/* fragment/blend_constant.c: blending by one alpha. A stage; see blend.h. */
#include "blend.h"
#include "blend_channel.h"

void etch_stage_blend_constant(struct etch_chunk *c, const void *data)
{
    const uint32_t a = ((const struct etch_blend_constant *)data)->alpha * UINT32_C(256);

    for (uint16_t i = 0; i < c->n; i++) {
        const uint16_t d = c->pixel[i];

        c->r[i] = (uint16_t)(etch_blend_mix(c->r[i], etch_pixel_red(d), a, 11) << 11);
        c->g[i] = (uint16_t)(etch_blend_mix(c->g[i], etch_pixel_green(d), a, 10) << 10);
        c->b[i] = (uint16_t)(etch_blend_mix(c->b[i], etch_pixel_blue(d), a, 11) << 11);
    }
}
