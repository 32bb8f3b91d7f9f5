/* fragment/write.c: a chunk's colours into the plane. Stages; see write.h. */
#include "write.h"
#include "../base/rgb565.h"

void etch_stage_write(struct etch_chunk *c, const void *data)
{
    uint16_t *const pixels = c->surface->pixels + c->first;

    (void)data;
    for (uint16_t i = 0, left = c->alive; left != 0; i++, left >>= 1)
        if ((left & 1) != 0)
            pixels[i] = etch_chunk_pixel(c, i);
}

void etch_stage_write_swapped(struct etch_chunk *c, const void *data)
{
    uint16_t *const pixels = c->surface->pixels + c->first;

    (void)data;
    for (uint16_t i = 0, left = c->alive; left != 0; i++, left >>= 1)
        if ((left & 1) != 0)
            pixels[i] = etch_rgb565_swap(etch_chunk_pixel(c, i));
}
