/* fragment/read.c: stored pixels into a chunk. Stages; see write.h. */
#include "../base/rgb565.h"
#include "write.h"

void etch_stage_read(struct etch_chunk *c, const void *data)
{
    const uint16_t *const pixels = c->surface->pixels + c->first;

    (void)data;
    for (uint16_t i = 0; i < c->n; i++)
        c->pixel[i] = pixels[i];
}

void etch_stage_read_swapped(struct etch_chunk *c, const void *data)
{
    const uint16_t *const pixels = c->surface->pixels + c->first;

    (void)data;
    for (uint16_t i = 0; i < c->n; i++)
        c->pixel[i] = etch_rgb565_swap(pixels[i]);
}
