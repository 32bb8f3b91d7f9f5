/* fragment/texture_modulate.c: the fragment's colour times the texture's. A stage, called by
 * etch_kernel_staged. See sampler.h. */
#include "sampler.h"
#include "texture_factor.h"

/* v factor / 2^16, rounded: at most 65535 x 65536 + 2^15 < 2^32. */
ETCH_INLINE uint16_t scaled(uint16_t v, uint32_t factor)
{
    return (uint16_t)((v * factor + 32768) >> 16);
}

void etch_stage_texture_modulate(struct etch_chunk *chunk, const void *data)
{
    const struct etch_sampler *const sampler = (const struct etch_sampler *)data;
    const uint16_t n = chunk->n;
    uint16_t r[ETCH_CHUNK], g[ETCH_CHUNK], b[ETCH_CHUNK], a[ETCH_CHUNK];
    const struct etch_texels texels = {r, g, b, a};

    sampler->filter(&texels, chunk, sampler);
    for (uint16_t i = 0; i < n; i++) {
        chunk->r[i] = scaled(chunk->r[i], etch_factor_q11(r[i]));
        chunk->g[i] = scaled(chunk->g[i], etch_factor_q10(g[i]));
        chunk->b[i] = scaled(chunk->b[i], etch_factor_q11(b[i]));
    }
    if (sampler->image.alphas == NULL)
        return;
    for (uint16_t i = 0; i < n; i++)
        chunk->a[i] = scaled(chunk->a[i], etch_factor_q8(a[i]));
}
