/* fragment/filter_nearest.c: the texel that holds a coordinate. Called by the texture stages, through
 * the sampler. See sampler.h. */
#include "sampler.h"

void etch_filter_nearest(const struct etch_texels *out, const struct etch_chunk *chunk,
                         const struct etch_sampler *sampler)
{
    const struct etch_image *const image = &sampler->image;
    const uint16_t n = chunk->n;
    uint16_t column[ETCH_CHUNK], row[ETCH_CHUNK], color[ETCH_CHUNK];
    uint8_t alpha[ETCH_CHUNK];

    sampler->wrap_u(column, chunk->u, n, 0, image->width);
    sampler->wrap_v(row, chunk->v, n, 0, image->height);
    image->colors(color, column, row, n, image);
    for (uint16_t i = 0; i < n; i++) {
        const uint32_t c = color[i];

        out->r[i] = (uint16_t)(c & 0xF800);
        out->g[i] = (uint16_t)(c << 5 & 0xFC00);
        out->b[i] = (uint16_t)(c << 11 & 0xF800);
    }
    if (image->alphas == NULL)
        return;
    image->alphas(alpha, column, row, n, image);
    for (uint16_t i = 0; i < n; i++)
        out->a[i] = (uint16_t)((uint32_t)alpha[i] << 8);
}
