/* fragment/mipmap_build.c: box-filtered levels of an image. Called by applications at set-up. See
 * mipmap.h. */
#include "mipmap.h"
#include "sampler.h"

/* Sums of the channels over a box: weights sum to width x height < 2^30, so each is below 2^38. */
struct sums {
    uint64_t r, g, b, a;
};

/* Where a texel of a level lies along one side: level 0 has `size` texels, the level `parts`. In
 * units of 1 / (size parts) of the side, texel j of the level covers [j size, (j + 1) size), texel
 * i of level 0 [i parts, (i + 1) parts). */
struct extent {
    uint32_t from, to;
    uint16_t parts;
};

static struct extent extent_of(uint16_t j, uint16_t size, uint16_t parts)
{
    const struct extent e = {etch_mul_u16(j, size), etch_mul_u16(j, size) + size, parts};

    return e;
}

/* How much of texel i lies in the extent; 1 .. parts for those that touch it. */
static uint16_t overlap(const struct extent *e, uint16_t i)
{
    const uint32_t from = etch_mul_u16(i, e->parts), to = from + e->parts;

    return (uint16_t)((to < e->to ? to : e->to) - (from > e->from ? from : e->from));
}

/* n texels from `first` on of one row of level 0, weighted. */
static void add_texels(struct sums *s, const struct etch_image *image, const struct extent *across,
                       uint16_t first, uint16_t n, uint16_t y, uint16_t weight)
{
    uint16_t column[ETCH_CHUNK], row[ETCH_CHUNK], color[ETCH_CHUNK];
    uint8_t alpha[ETCH_CHUNK];

    for (uint16_t i = 0; i < n; i++) {
        column[i] = (uint16_t)(first + i);
        row[i] = y;
    }
    image->colors(color, column, row, n, image);
    if (image->alphas != NULL)
        image->alphas(alpha, column, row, n, image);
    for (uint16_t i = 0; i < n; i++) {
        const uint32_t part = etch_mul_u16(overlap(across, column[i]), weight); /* < 2^30 */

        s->r += (uint64_t)part * (uint32_t)(color[i] >> 11);
        s->g += (uint64_t)part * (uint32_t)(color[i] >> 5 & 63);
        s->b += (uint64_t)part * (uint32_t)(color[i] & 31);
        s->a += image->alphas != NULL ? (uint64_t)part * alpha[i] : 0;
    }
}

static struct sums sums_of(const struct etch_image *image, const struct extent *across,
                           const struct extent *down)
{
    struct sums s = {0, 0, 0, 0};

    for (uint32_t y = down->from / down->parts; y * down->parts < down->to; y++) {
        uint32_t x = across->from / across->parts;
        const uint32_t end = (across->to + across->parts - 1) / across->parts;

        while (x < end) {
            const uint32_t n = end - x < ETCH_CHUNK ? end - x : ETCH_CHUNK;

            add_texels(&s, image, across, (uint16_t)x, (uint16_t)n, (uint16_t)y,
                       overlap(down, (uint16_t)y));
            x += n;
        }
    }
    return s;
}

static uint32_t mean(uint64_t sum, uint32_t area)
{
    return (uint32_t)etch_divide_u64(sum + area / 2, area).quotient;
}

/* Fills one level; alpha is not touched where the image has none. */
static void build_level(const struct etch_image *image, uint16_t *texels, uint8_t *alpha,
                        uint16_t width, uint16_t height)
{
    const uint32_t area = etch_mul_u16(image->width, image->height);

    for (uint16_t y = 0; y < height; y++) {
        const struct extent down = extent_of(y, image->height, height);

        for (uint16_t x = 0; x < width; x++) {
            const struct extent across = extent_of(x, image->width, width);
            const struct sums s = sums_of(image, &across, &down);

            *texels++ = (uint16_t)(mean(s.r, area) << 11 | mean(s.g, area) << 5 | mean(s.b, area));
            if (image->alphas != NULL)
                *alpha++ = (uint8_t)mean(s.a, area);
        }
    }
}

/* Halves a side. */
static uint16_t half(uint16_t side)
{
    return side > 1 ? (uint16_t)(side >> 1) : 1;
}

uint32_t etch_mipmap_texels(uint16_t width, uint16_t height)
{
    uint32_t texels = 0;

    while (width > 1 || height > 1) {
        width = half(width);
        height = half(height);
        texels += etch_mul_u16(width, height);
    }
    return texels;
}

enum etch_status etch_mipmap_build(struct etch_mipmap *m, const struct etch_image *image,
                                   uint16_t *texels, uint8_t *alpha, uint32_t capacity)
{
    struct etch_image level = {etch_texels_rgb565, NULL, texels, NULL, NULL, 0, 0, 0};

    if (!etch_image_valid(image) || texels == NULL || (image->alphas != NULL && alpha == NULL))
        return ETCH_EINVAL;
    if (capacity < etch_mipmap_texels(image->width, image->height))
        return ETCH_ENOMEM;
    m->level[0] = *image;
    m->count = 1;
    for (uint16_t w = image->width, h = image->height; w > 1 || h > 1; m->count++) {
        w = half(w), h = half(h);
        build_level(image, texels, alpha, w, h);
        level.width = level.stride = w;
        level.height = h;
        level.texels = texels;
        texels += etch_mul_u16(w, h);
        if (image->alphas != NULL) {
            level.alphas = etch_texels_mask;
            level.alpha = alpha;
            alpha += etch_mul_u16(w, h);
        }
        m->level[m->count] = level;
    }
    return ETCH_OK;
}
