/* fragment/sampler.h: textures of any size and format as stages of pixel work (stage.h).
 *
 *      chunk u, v --> wrap --> texels --> filter --> environment --> chunk r, g, b, a
 *
 * Each box is a named function that works on a whole chunk, and a sampler names one of each: what
 * no sampler of a program names is not linked, and every combination works.
 *
 *  format        .colors                .alphas                  texels
 *  RGB565        etch_texels_rgb565     NULL                     uint16_t each
 *   + mask       etch_texels_rgb565     etch_texels_mask         alpha: a byte a texel
 *  palette, 8    etch_texels_index8     NULL                     a byte each, 256 colours
 *   + alpha      etch_texels_index8     etch_texels_alpha8       alpha: a byte a colour
 *  palette, 4    etch_texels_index4     NULL                     16 colours, two texels a byte:
 *   + alpha      etch_texels_index4     etch_texels_alpha4         texel row * stride + column,
 *                                                                  even ones in the low half
 *  palette, 2    etch_texels_index2     NULL                     4 colours, first in low bits
 *  palette, 1    etch_texels_index1     NULL                     2 colours, first in low bits
 *  RGB565, key   etch_texels_rgb565     etch_texels_unlike       transparent: palette[0]; `alpha`
 *                                                                  is not NULL, not read
 *  mask, 8       etch_texels_ink        etch_texels_mask         alpha: a byte a texel; the colour
 *  mask, 4       etch_texels_ink        etch_texels_mask4          palette[0]; `texels` not read
 *
 *      filter        etch_filter_nearest, etch_filter_linear
 *      wrap          etch_texels_repeat, etch_texels_clamp, etch_texels_mirror; faster where the
 *                    side is a power of two: etch_texels_repeat_power, etch_texels_mirror_power
 *      environment   etch_stage_texture_replace, _modulate, _decal
 *
 * Texel k covers [k, k + 1). Every u and v is legal; wraps are exact for all of them.
 *
 * Instructions a texel on Cortex-M0+ (M4), RGB565, repeated, sides a power of two, replace:
 *
 *                    nearest      linear
 *      by parts      63 (34)    265 (145)    any combination; each part once in flash
 *      fused         30 (18)    157 (88)     a function for each combination, texel.h
 *
 * and for nearest by parts: clamp 9 more, repeat any size 16, mirror 25, 4-bit texels 14, alpha 23,
 * modulate 60, decal with alpha 93, which includes its alpha.
 */
#ifndef ETCH_FRAGMENT_SAMPLER_H
#define ETCH_FRAGMENT_SAMPLER_H

#include "../base/texture.h"
#include "stage.h"

/* texel[i] = the texel, 0 .. size - 1, that holds coordinate c_q16[i] + shift_q15 / 2^15; |shift|
 * is at most half a texel, 2^14. */
typedef void etch_texel_wrap(uint16_t *texel, const int32_t *c_q16, uint16_t n, int16_t shift_q15,
                             uint16_t size);

/* ..., -2 -> size - 2, -1 -> size - 1, 0 -> 0, .. size -> 0, ... */
etch_texel_wrap etch_texels_repeat;       /* any size; divides where a period ends */
etch_texel_wrap etch_texels_repeat_power; /* powers of two */

/* Below 0 the first texel, from size on the last one. */
etch_texel_wrap etch_texels_clamp;

/* ..., -2 -> 1, -1 -> 0, 0 -> 0, .. size -> size - 1, size + 1 -> size - 2, ... */
etch_texel_wrap etch_texels_mirror;
etch_texel_wrap etch_texels_mirror_power;

etch_texel_colors etch_texels_rgb565, etch_texels_index8, etch_texels_index4, etch_texels_index2;
etch_texel_colors etch_texels_index1, etch_texels_ink;
etch_texel_alphas etch_texels_mask, etch_texels_mask4, etch_texels_alpha8, etch_texels_alpha4;
etch_texel_alphas etch_texels_unlike;

/* Where a filter writes, in the formats of a chunk. a is only written if the image has alpha. */
struct etch_texels {
    uint16_t *r, *g, *b, *a;
};

struct etch_sampler;
typedef void etch_texel_filter(const struct etch_texels *out, const struct etch_chunk *chunk,
                               const struct etch_sampler *sampler);

/* The texel that holds (u, v), exactly. */
etch_texel_filter etch_filter_nearest;

/* The four texels round (u, v), weighted by how near their centres are, as OpenGL's GL_LINEAR: at
 * the centre of a texel that texel, exactly. Weights have 11 bits and sum to 1: the result errs by
 * at most 1/1024 of the greatest difference between the four texels, and 1/2 unit of the chunk's
 * formats, against exact rational weights. Colours and alpha are weighted alike and apart: colours
 * are not multiplied by alpha first, so the colour of transparent texels shows at the edge of what
 * is opaque (mipmap.h says what to do). 420 bytes of stack on ARM. */
etch_texel_filter etch_filter_linear;

/* The same, fused for opaque RGB565 with sides that are powers of two, repeated, in half the time;
 * they do not look at the sampler's other functions. texel.h makes others in a line. */
etch_texel_filter etch_filter_nearest_power, etch_filter_linear_power;

/* etch_filter_linear fused for opaque RGB565 of any size, clamped. */
etch_texel_filter etch_filter_linear_clamp;

struct etch_sampler {
    struct etch_image image;
    etch_texel_filter *filter;
    etch_texel_wrap *wrap_u, *wrap_v;
};

/* Describes an image that is sampled alike both ways. ETCH_EINVAL if it is not etch_image_valid or
 * a function is NULL; *s is then left as it was. A sampler may also be filled in by hand. */
enum etch_status etch_sampler_init(struct etch_sampler *s, const struct etch_image *image,
                                   etch_texel_filter *filter, etch_texel_wrap *wrap);

/* Stages; data is a struct etch_sampler. With f the chunk's colour and t the texture's, 1 = full:
 *
 *                     opaque image          image with alpha
 *      replace        t       | a = f.a     t                            | a = t.a
 *      modulate       f t     | a = f.a     f t                          | a = f.a t.a
 *      decal          t       | a = f.a     f (1 - t.a) + t t.a          | a = f.a
 *
 * as OpenGL's texture environments. Replace is exact. Modulate errs by at most 3/2, decal by 2
 * units of the chunk's formats, 1/1000 of an output step, and a full factor changes no pixel. Every
 * pixel of the chunk is sampled, alive or not. */
etch_stage_function etch_stage_texture_replace;
etch_stage_function etch_stage_texture_modulate;
etch_stage_function etch_stage_texture_decal;

#endif
