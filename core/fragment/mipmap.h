/* fragment/mipmap.h: smaller copies of an image, one of which a triangle is drawn with.
 *
 * Level 0 is the image, level k + 1 half as wide and high as level k (rounded down, 1 at least), to
 * 1 x 1. A triangle is drawn with the level whose texels are nearest to the size of a pixel:
 *
 *      for each triangle:  level = etch_mipmap_level(..);  sampler.image = mipmap.level[level];
 *                          etch_mipmap_vertex(..) for each vertex;  then draw those vertices
 *
 * Where the sides are powers of two, the fused kernels of texture.h can draw every level k > 0:
 * etch_texture_init(&texture, level.texels, level.width, level.height).
 */
#ifndef ETCH_FRAGMENT_MIPMAP_H
#define ETCH_FRAGMENT_MIPMAP_H

#include "../base/texture.h"

#define ETCH_MIPMAP_LEVELS 15 /* of a side of 32767 */

struct etch_mipmap {
    struct etch_image level[ETCH_MIPMAP_LEVELS];
    uint8_t count; /* 1 .. ETCH_MIPMAP_LEVELS */
};

/* Texels of all levels below level 0 of such an image: uint16_t words that etch_mipmap_build needs
 * (and bytes of alpha, if the image has alpha). At most a third of width * height, and the sides.
 */
uint32_t etch_mipmap_texels(uint16_t width, uint16_t height);

/* Builds the levels of `image`, of any format, as RGB565 into `texels` and, if it has alpha, as a
 * mask into `alpha` (else not read); both hold `capacity` texels. The image becomes level 0.
 * A texel is the mean of the part of level 0 that it covers, texels at its border counting by their
 * part, each channel rounded to nearest once, half up: levels do not round one another's roundings.
 * Colours are not weighted by alpha: a transparent texel's colour counts like any other, so give
 * transparent texels the colour of what they border on, or a fringe of theirs shows at edges that
 * are blended or cut by the alpha test.
 * ETCH_EINVAL if the image is not etch_image_valid or memory is NULL, ETCH_ENOMEM if capacity is
 * below etch_mipmap_texels; *m is then left as it was. Time: all of the image for each level; on
 * small machines build offline. */
enum etch_status etch_mipmap_build(struct etch_mipmap *m, const struct etch_image *image,
                                   uint16_t *texels, uint8_t *alpha, uint32_t capacity);

/* The level for a triangle: with T its area in texels (u and v rounded down to 1/256) and P in
 * pixels, the greatest level k < count with 4^k <= 2 T / P, which is log2(sqrt(T / P)) rounded to
 * nearest; 0 if there is none. Depends on the triangle alone: not on clips, strips or the order of
 * its vertices. */
uint8_t etch_mipmap_level(const struct etch_mipmap *m,
                          const struct etch_texture_vertex *const v[3]);

/* The vertex with its coordinates in texels of that level: u width_k / width, rounded half up. */
void etch_mipmap_vertex(struct etch_texture_vertex *out, const struct etch_texture_vertex *v,
                        const struct etch_mipmap *m, uint8_t level);

#endif
