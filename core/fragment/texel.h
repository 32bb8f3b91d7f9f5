/* fragment/texel.h: the parts that the functions of sampler.h are made from, shipped ones and
 * yours.
 *
 * An address is an inline function from a whole coordinate to a texel, a format one from an image
 * and the place of a texel to its colour or alpha. One line makes a function over a chunk from one
 * of them, or fuses a filter from all of them, which then looks at no other function of the
 * sampler:
 *
 *      ETCH_FILTER_NEAREST(my_filter, etch_address_clamp, etch_texel_index4, etch_texel_alpha4)
 *
 * What it gains stands in sampler.h.
 */
#ifndef ETCH_FRAGMENT_TEXEL_H
#define ETCH_FRAGMENT_TEXEL_H

#include "sampler.h"

/* ---- addresses: the texel, 0 .. size - 1, of the whole coordinate k, -32769 .. 32768. *first is 0
 * at the first of a row of pixels, then the function's own. -------------------------------------
 */

typedef uint16_t etch_texel_address(int32_t k, uint16_t size, int32_t *first);

/* k less *first, the period's multiple that is not above k. Neighbours mostly lie in the same
 * period: only a new one costs a division. 1 <= period <= 65534. */
ETCH_INLINE int32_t etch_address_period(int32_t k, int32_t period, int32_t *first)
{
    if (k < *first || k - *first >= period) {
        const int32_t multiple = k / period * period;

        *first = multiple > k ? multiple - period : multiple;
    }
    return k - *first;
}

ETCH_INLINE uint16_t etch_address_repeat(int32_t k, uint16_t size, int32_t *first)
{
    return (uint16_t)etch_address_period(k, size, first);
}

ETCH_INLINE uint16_t etch_address_repeat_power(int32_t k, uint16_t size, int32_t *first)
{
    (void)first;
    return (uint16_t)((uint32_t)k & ((uint32_t)size - 1));
}

ETCH_INLINE uint16_t etch_address_clamp(int32_t k, uint16_t size, int32_t *first)
{
    (void)first;
    return (uint16_t)(k < 0 ? 0 : k >= size ? size - 1 : k);
}

ETCH_INLINE uint16_t etch_address_mirror(int32_t k, uint16_t size, int32_t *first)
{
    const int32_t period = (int32_t)size * 2, in = etch_address_period(k, period, first);

    return (uint16_t)(in < size ? in : period - 1 - in);
}

/* In a mirrored period the bit of the size is set, and all bits below it are turned round. */
ETCH_INLINE uint16_t etch_address_mirror_power(int32_t k, uint16_t size, int32_t *first)
{
    const uint32_t c = (uint32_t)k;

    (void)first;
    return (uint16_t)(((c & size) != 0 ? ~c : c) & ((uint32_t)size - 1));
}

/* floor(c + shift), -32769 .. 32768. Half the coordinate leaves room for the shift, and the bit
 * that it drops is below that of the shift. */
ETCH_INLINE int32_t etch_texel_floor(int32_t c_q16, int16_t shift_q15)
{
    return ((c_q16 >> 1) + shift_q15) >> 15;
}

/* Defines an etch_texel_wrap. */
#define ETCH_TEXEL_WRAP(name, address)                                                             \
    void name(uint16_t *texel, const int32_t *c_q16, uint16_t n, int16_t shift_q15, uint16_t size) \
    {                                                                                              \
        int32_t first = 0;                                                                         \
                                                                                                   \
        for (uint16_t i = 0; i < n; i++)                                                           \
            texel[i] = address(etch_texel_floor(c_q16[i], shift_q15), size, &first);               \
    }

/* ---- formats: the texel at `place`, row * stride + column ------------------------------------ */

typedef uint16_t etch_texel_color(const struct etch_image *image, uint32_t place);
typedef uint8_t etch_texel_alpha(const struct etch_image *image, uint32_t place);

ETCH_INLINE uint16_t etch_texel_rgb565(const struct etch_image *image, uint32_t place)
{
    return ((const uint16_t *)image->texels)[place];
}

ETCH_INLINE uint8_t etch_texel_mask(const struct etch_image *image, uint32_t place)
{
    return image->alpha[place];
}

ETCH_INLINE uint8_t etch_texel_byte(const struct etch_image *image, uint32_t place)
{
    return ((const uint8_t *)image->texels)[place];
}

ETCH_INLINE uint8_t etch_texel_nibble(const struct etch_image *image, uint32_t place)
{
    const uint8_t pair = etch_texel_byte(image, place >> 1);

    return (uint8_t)((place & 1) != 0 ? pair >> 4 : pair & 15);
}

ETCH_INLINE uint16_t etch_texel_index8(const struct etch_image *image, uint32_t place)
{
    return image->palette[etch_texel_byte(image, place)];
}

ETCH_INLINE uint8_t etch_texel_alpha8(const struct etch_image *image, uint32_t place)
{
    return image->alpha[etch_texel_byte(image, place)];
}

ETCH_INLINE uint16_t etch_texel_index4(const struct etch_image *image, uint32_t place)
{
    return image->palette[etch_texel_nibble(image, place)];
}

ETCH_INLINE uint8_t etch_texel_alpha4(const struct etch_image *image, uint32_t place)
{
    return image->alpha[etch_texel_nibble(image, place)];
}

/* Two bits and one, the first texel of a byte in its lowest bits. */
ETCH_INLINE uint8_t etch_texel_pair(const struct etch_image *image, uint32_t place)
{
    return (uint8_t)((uint32_t)etch_texel_byte(image, place >> 2) >> (place & 3) * 2 & 3);
}

ETCH_INLINE uint8_t etch_texel_bit(const struct etch_image *image, uint32_t place)
{
    return (uint8_t)((uint32_t)etch_texel_byte(image, place >> 3) >> (place & 7) & 1);
}

ETCH_INLINE uint16_t etch_texel_index2(const struct etch_image *image, uint32_t place)
{
    return image->palette[etch_texel_pair(image, place)];
}

ETCH_INLINE uint16_t etch_texel_index1(const struct etch_image *image, uint32_t place)
{
    return image->palette[etch_texel_bit(image, place)];
}

/* One colour, for masks. */
ETCH_INLINE uint16_t etch_texel_ink(const struct etch_image *image, uint32_t place)
{
    (void)place;
    return image->palette[0];
}

/* A plane of alpha with 4 bits a texel, even ones in the low half. */
ETCH_INLINE uint8_t etch_texel_mask4(const struct etch_image *image, uint32_t place)
{
    const uint32_t pair = image->alpha[place >> 1];

    return (uint8_t)(((place & 1) != 0 ? pair >> 4 : pair & 15) * 17);
}

/* 0 where an RGB565 texel has the key colour palette[0], 255 elsewhere. */
ETCH_INLINE uint8_t etch_texel_unlike(const struct etch_image *image, uint32_t place)
{
    return etch_texel_rgb565(image, place) == image->palette[0] ? 0 : 255;
}

/* Defines an etch_texel_colors (type uint16_t) or etch_texel_alphas (uint8_t). */
#define ETCH_TEXEL_FORMAT(name, type, texel)                                                       \
    void name(type *out, const uint16_t *column, const uint16_t *row, uint16_t n,                  \
              const struct etch_image *image)                                                      \
    {                                                                                              \
        const struct etch_image here = *image;                                                     \
                                                                                                   \
        for (uint16_t i = 0; i < n; i++)                                                           \
            out[i] = texel(&here, etch_mul_u16(row[i], here.stride) + column[i]);                  \
    }

/* ---- filters --------------------------------------------------------------------------------- */

/* A colour in the formats of a chunk. */
ETCH_INLINE void etch_texel_put(const struct etch_texels *out, uint16_t i, uint32_t color)
{
    out->r[i] = (uint16_t)(color & 0xF800);
    out->g[i] = (uint16_t)(color << 5 & 0xFC00);
    out->b[i] = (uint16_t)(color << 11 & 0xF800);
}

/* The four texels round a coordinate, above left first, weigh 0 .. 2048, in all 2048. */
struct etch_texel_weights {
    uint32_t of[4];
};

/* The distance to the centre of the texel on the left, 0 .. 2048, rounded. */
ETCH_INLINE uint32_t etch_texel_fraction(int32_t c_q16)
{
    return ((((uint32_t)c_q16 & 0xFFFF) ^ 0x8000) + 16) >> 5;
}

/* Each is the product of two distances, rounded: three follow from the fourth. It is at most the
 * lesser distance; and 2048 - u - v + uv/2048 is the product of the other two distances. */
ETCH_INLINE struct etch_texel_weights etch_texel_weigh(int32_t u_q16, int32_t v_q16)
{
    const uint32_t u = etch_texel_fraction(u_q16), v = etch_texel_fraction(v_q16);
    const uint32_t both = (u * v + 1024) >> 11;
    const struct etch_texel_weights weights = {{2048 - u - (v - both), u - both, v - both, both}};

    return weights;
}

/* Weighted sums. Red and blue share a word, each in 16 bits: 31 x 2048 < 2^16, which is 5.11
 * already. Green stands 5 bits up, 6.16, alpha is 8.11. */
struct etch_texel_sums {
    uint32_t red_blue, green, alpha;
};

ETCH_INLINE void etch_texel_add(struct etch_texel_sums *s, uint32_t color, uint32_t weight)
{
    s->red_blue += ((color & 0xF800) << 5 | (color & 0x1F)) * weight;
    s->green += (color & 0x07E0) * weight;
}

ETCH_INLINE void etch_texel_put_sums(const struct etch_texels *out, uint16_t i,
                                     const struct etch_texel_sums *s)
{
    out->r[i] = (uint16_t)(s->red_blue >> 16);
    out->g[i] = (uint16_t)((s->green + 32) >> 6);
    out->b[i] = (uint16_t)(s->red_blue & 0xFFFF);
}

ETCH_INLINE uint16_t etch_texel_mean_alpha(const struct etch_texel_sums *s)
{
    return (uint16_t)((s->alpha + 4) >> 3);
}

/* What ETCH_FILTER_NEAREST and _LINEAR fuse; alpha NULL: the image is opaque. */
ETCH_INLINE void etch_filter_nearest_parts(const struct etch_texels *out,
                                           const struct etch_chunk *chunk,
                                           const struct etch_image *image,
                                           etch_texel_address *address, etch_texel_color *color,
                                           etch_texel_alpha *alpha)
{
    const struct etch_texels to = *out;
    const struct etch_image here = *image;
    const uint16_t n = chunk->n;
    int32_t first_u = 0, first_v = 0;

    for (uint16_t i = 0; i < n; i++) {
        const uint16_t column = address(chunk->u[i] >> 16, here.width, &first_u);
        const uint16_t row = address(chunk->v[i] >> 16, here.height, &first_v);
        const uint32_t place = etch_mul_u16(row, here.stride) + column;

        etch_texel_put(&to, i, color(&here, place));
        if (alpha != NULL)
            to.a[i] = (uint16_t)((uint32_t)alpha(&here, place) << 8);
    }
}

ETCH_INLINE void etch_filter_linear_parts(const struct etch_texels *out,
                                          const struct etch_chunk *chunk,
                                          const struct etch_image *image,
                                          etch_texel_address *address, etch_texel_color *color,
                                          etch_texel_alpha *alpha)
{
    const struct etch_texels to = *out;
    const struct etch_image here = *image;
    const uint16_t n = chunk->n;
    int32_t first_u = 0, first_v = 0;

    for (uint16_t i = 0; i < n; i++) {
        const int32_t u = etch_texel_floor(chunk->u[i], -0x4000);
        const int32_t v = etch_texel_floor(chunk->v[i], -0x4000);
        const uint32_t left = address(u, here.width, &first_u);
        const uint32_t right = address(u + 1, here.width, &first_u);
        const uint32_t above = etch_mul_u16(address(v, here.height, &first_v), here.stride);
        const uint32_t below = etch_mul_u16(address(v + 1, here.height, &first_v), here.stride);
        const uint32_t place[4] = {above + left, above + right, below + left, below + right};
        const struct etch_texel_weights weights = etch_texel_weigh(chunk->u[i], chunk->v[i]);
        struct etch_texel_sums sums = {0, 0, 0};

        ETCH_UNROLL(4)
        for (uint8_t k = 0; k < 4; k++) {
            etch_texel_add(&sums, color(&here, place[k]), weights.of[k]);
            if (alpha != NULL)
                sums.alpha += alpha(&here, place[k]) * weights.of[k];
        }
        etch_texel_put_sums(&to, i, &sums);
        if (alpha != NULL)
            to.a[i] = etch_texel_mean_alpha(&sums);
    }
}

/* Define the etch_texel_filter `name`. alpha NULL: opaque images. */
#define ETCH_FILTER_NEAREST(name, address, color, alpha)                                           \
    void name(const struct etch_texels *out, const struct etch_chunk *chunk,                       \
              const struct etch_sampler *sampler)                                                  \
    {                                                                                              \
        etch_filter_nearest_parts(out, chunk, &sampler->image, address, color, alpha);             \
    }

#define ETCH_FILTER_LINEAR(name, address, color, alpha)                                            \
    void name(const struct etch_texels *out, const struct etch_chunk *chunk,                       \
              const struct etch_sampler *sampler)                                                  \
    {                                                                                              \
        etch_filter_linear_parts(out, chunk, &sampler->image, address, color, alpha);              \
    }

#endif
