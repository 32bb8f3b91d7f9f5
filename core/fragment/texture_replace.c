/* fragment/texture_replace.c: the texture's colour in place of the fragment's. A stage, called by
 * etch_kernel_staged. See sampler.h. */
#include "sampler.h"

void etch_stage_texture_replace(struct etch_chunk *chunk, const void *data)
{
    const struct etch_sampler *const sampler = (const struct etch_sampler *)data;
    const struct etch_texels out = {chunk->r, chunk->g, chunk->b, chunk->a};

    sampler->filter(&out, chunk, sampler);
}
