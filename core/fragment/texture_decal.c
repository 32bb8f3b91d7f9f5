/* fragment/texture_decal.c: the texture over the fragment's colour, by the texture's alpha. A
 * stage, called by etch_kernel_staged. See sampler.h. */
#include "sampler.h"
#include "texture_factor.h"

/* f + (t - f) alpha / 2^15, rounded; |t - f| < 2^16, 0 <= alpha <= 2^15. */
ETCH_INLINE uint16_t over(uint16_t f, uint16_t t, int32_t alpha_q15)
{
    return (uint16_t)(f + ((((int32_t)t - f) * alpha_q15 + 16384) >> 15));
}

void etch_stage_texture_decal(struct etch_chunk *chunk, const void *data)
{
    const struct etch_sampler *const sampler = (const struct etch_sampler *)data;
    const uint16_t n = chunk->n;
    uint16_t r[ETCH_CHUNK], g[ETCH_CHUNK], b[ETCH_CHUNK], a[ETCH_CHUNK];
    const struct etch_texels texels = {r, g, b, a};

    if (sampler->image.alphas == NULL) {
        etch_stage_texture_replace(chunk, data);
        return;
    }
    sampler->filter(&texels, chunk, sampler);
    for (uint16_t i = 0; i < n; i++) {
        const int32_t alpha_q15 = (int32_t)((etch_factor_q8(a[i]) + 1) >> 1);

        chunk->r[i] = over(chunk->r[i], r[i], alpha_q15);
        chunk->g[i] = over(chunk->g[i], g[i], alpha_q15);
        chunk->b[i] = over(chunk->b[i], b[i], alpha_q15);
    }
}
