/* fragment/blend_multiply.c: blending by multiplication. A stage; see blend.h. */
#include "blend.h"
#include "blend_channel.h"

void etch_stage_blend_multiply(struct etch_chunk *c, const void *data)
{
    (void)data;
    for (uint16_t i = 0; i < c->n; i++) {
        const uint16_t d = c->pixel[i];

        c->r[i] = (uint16_t)(etch_blend_product(c->r[i], etch_pixel_red(d), 11, 5) << 11);
        c->g[i] = (uint16_t)(etch_blend_product(c->g[i], etch_pixel_green(d), 10, 6) << 10);
        c->b[i] = (uint16_t)(etch_blend_product(c->b[i], etch_pixel_blue(d), 11, 5) << 11);
    }
}
