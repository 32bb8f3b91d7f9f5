/* fragment/blend_add_alpha.c: additive blending, weighted by alpha. A stage; see blend.h. */
#include "blend.h"
#include "blend_channel.h"

void etch_stage_blend_add_alpha(struct etch_chunk *c, const void *data)
{
    (void)data;
    for (uint16_t i = 0; i < c->n; i++) {
        const uint32_t a = c->a[i];
        const uint16_t d = c->pixel[i];
        const uint32_t r = etch_blend_sum(c->r[i], etch_pixel_red(d), a, 11);
        const uint32_t g = etch_blend_sum(c->g[i], etch_pixel_green(d), a, 10);
        const uint32_t b = etch_blend_sum(c->b[i], etch_pixel_blue(d), a, 11);

        c->r[i] = (uint16_t)(etch_blend_least(r, 31) << 11);
        c->g[i] = (uint16_t)(etch_blend_least(g, 63) << 10);
        c->b[i] = (uint16_t)(etch_blend_least(b, 31) << 11);
    }
}
