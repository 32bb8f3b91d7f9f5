/* fragment/filter_linear.c: the mean of the four nearest texels. Called by the texture stages, through
 * the sampler. See sampler.h. */
#include "sampler.h"

/* The texels above left, above right, below left and below right of a coordinate. */
struct corners {
    uint16_t column[2][ETCH_CHUNK], row[2][ETCH_CHUNK];
    uint16_t color[4][ETCH_CHUNK];
    uint8_t alpha[4][ETCH_CHUNK];
    uint16_t weight[4][ETCH_CHUNK]; /* 0 .. 2048; the four of a pixel sum to 2048 */
};

/* The distance to the centre of the texel on the left, 0 .. 2048, rounded. */
ETCH_INLINE uint32_t fraction_q11(int32_t c_q16)
{
    return ((((uint32_t)c_q16 & 0xFFFF) ^ 0x8000) + 16) >> 5;
}

/* Each is the product of two distances, rounded: three follow from the fourth. It is at most the
 * lesser distance; and 2048 - u - v + uv/2048 is the product of the other two distances. */
static void weigh(struct corners *c, const struct etch_chunk *chunk)
{
    for (uint16_t i = 0; i < chunk->n; i++) {
        const uint32_t u = fraction_q11(chunk->u[i]), v = fraction_q11(chunk->v[i]);
        const uint32_t both = (u * v + 1024) >> 11;

        c->weight[0][i] = (uint16_t)(2048 - u - (v - both));
        c->weight[1][i] = (uint16_t)(u - both);
        c->weight[2][i] = (uint16_t)(v - both);
        c->weight[3][i] = (uint16_t)both;
    }
}

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

/* Red and blue are summed in one word, each in 16 bits: 31 x 2048 < 2^16, which is 5.11 already.
 * Green stands 5 bits up: 6.16. */
static void mix_colors(const struct etch_texels *out, const struct corners *c, uint16_t n)
{
    for (uint16_t i = 0; i < n; i++) {
        uint32_t red_blue = 0, green = 32;

        ETCH_UNROLL(4)
        for (uint8_t k = 0; k < 4; k++) {
            const uint32_t color = c->color[k][i], weight = c->weight[k][i];

            red_blue += ((color & 0xF800) << 5 | (color & 0x1F)) * weight;
            green += (color & 0x07E0) * weight;
        }
        out->r[i] = (uint16_t)(red_blue >> 16);
        out->g[i] = (uint16_t)(green >> 6);
        out->b[i] = (uint16_t)(red_blue & 0xFFFF);
    }
}

static void mix_alphas(const struct etch_texels *out, const struct corners *c, uint16_t n)
{
    for (uint16_t i = 0; i < n; i++) {
        uint32_t alpha = 4; /* 8.11 */

        for (uint8_t k = 0; k < 4; k++)
            alpha += (uint32_t)c->alpha[k][i] * c->weight[k][i];
        out->a[i] = (uint16_t)(alpha >> 3);
    }
}

void etch_filter_linear(const struct etch_texels *out, const struct etch_chunk *chunk,
                        const struct etch_sampler *sampler)
{
    struct corners c;

    fetch(&c, chunk, sampler);
    weigh(&c, chunk);
    mix_colors(out, &c, chunk->n);
    if (sampler->image.alphas != NULL)
        mix_alphas(out, &c, chunk->n);
}
