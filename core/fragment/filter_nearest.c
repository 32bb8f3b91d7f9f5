/* fragment/filter_nearest.c: the texel that holds a coordinate. Called by the texture stages,
 * through the sampler. See sampler.h. */
#include "texel.h"

void etch_filter_nearest(const struct etch_texels *out, const struct etch_chunk *chunk,
                         const struct etch_sampler *sampler)
{
    const struct etch_image *const image = &sampler->image;
    const struct etch_texels to = *out;
    const uint16_t n = chunk->n;
    uint16_t column[ETCH_CHUNK], row[ETCH_CHUNK], color[ETCH_CHUNK];
    uint8_t alpha[ETCH_CHUNK];

    sampler->wrap_u(column, chunk->u, n, 0, image->width);
    sampler->wrap_v(row, chunk->v, n, 0, image->height);
    image->colors(color, column, row, n, image);
    for (uint16_t i = 0; i < n; i++)
        etch_texel_put(&to, i, color[i]);
    if (image->alphas == NULL)
        return;
    image->alphas(alpha, column, row, n, image);
    for (uint16_t i = 0; i < n; i++)
        to.a[i] = (uint16_t)((uint32_t)alpha[i] << 8);
}
