/* fragment/color_mask.c: keeps bits of the stored pixel. A stage; see write.h. */
#include "write.h"

void etch_stage_color_mask(struct etch_chunk *c, const void *data)
{
    const uint32_t bits = ((const struct etch_color_mask *)data)->bits;

    for (uint16_t i = 0; i < c->n; i++)
        etch_chunk_set_pixel(c, i,
                             (uint16_t)((etch_chunk_pixel(c, i) & bits) | (c->pixel[i] & ~bits)));
}
