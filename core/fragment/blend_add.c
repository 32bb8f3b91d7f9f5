/* fragment/blend_add.c: additive blending. A stage; see blend.h. */
#include "blend.h"
#include "blend_channel.h"

void etch_stage_blend_add(struct etch_chunk *c, const void *data)
{
    (void)data;
    for (uint16_t i = 0; i < c->n; i++) {
        const uint16_t d = c->pixel[i];

        /* the sum has 17 bits; writing rounds it, so it is held to full and not beyond */
        c->r[i] = (uint16_t)etch_blend_least(c->r[i] + (etch_pixel_red(d) << 11),
                                             ETCH_CHUNK_RED_MAX);
        c->g[i] = (uint16_t)etch_blend_least(c->g[i] + (etch_pixel_green(d) << 10),
                                             ETCH_CHUNK_GREEN_MAX);
        c->b[i] = (uint16_t)etch_blend_least(c->b[i] + (etch_pixel_blue(d) << 11),
                                             ETCH_CHUNK_RED_MAX);
    }
}
