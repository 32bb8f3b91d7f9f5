/* fragment/filter_linear.c: the mean of the four nearest texels. Called by the texture stages,
 * through the sampler. See sampler.h. */
#include "texel.h"

/* The texels above left, above right, below left and below right of each coordinate. */
struct corners {
    uint16_t column[2][ETCH_CHUNK], row[2][ETCH_CHUNK];
    uint16_t color[4][ETCH_CHUNK];
    uint8_t alpha[4][ETCH_CHUNK];
};

static void fetch(struct corners *c, const struct etch_chunk *chunk,
                  const struct etch_sampler *sampler)
{
    const struct etch_image *const image = &sampler->image;
    const uint16_t n = chunk->n;

    for (uint8_t k = 0; k < 2; k++) {
        const int16_t shift_q15 = k == 0 ? -0x4000 : 0x4000;

        sampler->wrap_u(c->column[k], chunk->u, n, shift_q15, image->width);
        sampler->wrap_v(c->row[k], chunk->v, n, shift_q15, image->height);
    }
    for (uint8_t k = 0; k < 4; k++) {
        image->colors(c->color[k], c->column[k & 1], c->row[k >> 1], n, image);
        if (image->alphas != NULL)
            image->alphas(c->alpha[k], c->column[k & 1], c->row[k >> 1], n, image);
    }
}

static void mix(const struct etch_texels *out, const struct corners *c,
                const struct etch_chunk *chunk, bool opaque)
{
    for (uint16_t i = 0; i < chunk->n; i++) {
        const struct etch_texel_weights weights = etch_texel_weigh(chunk->u[i], chunk->v[i]);
        struct etch_texel_sums sums = {0, 0, 0};

        ETCH_UNROLL(4)
        for (uint8_t k = 0; k < 4; k++)
            etch_texel_add(&sums, c->color[k][i], weights.of[k]);
        etch_texel_put_sums(out, i, &sums);
        if (opaque)
            continue;
        for (uint8_t k = 0; k < 4; k++)
            sums.alpha += c->alpha[k][i] * weights.of[k];
        out->a[i] = etch_texel_mean_alpha(&sums);
    }
}

void etch_filter_linear(const struct etch_texels *out, const struct etch_chunk *chunk,
                        const struct etch_sampler *sampler)
{
    struct corners c;

    fetch(&c, chunk, sampler);
    mix(out, &c, chunk, sampler->image.alphas == NULL);
}
