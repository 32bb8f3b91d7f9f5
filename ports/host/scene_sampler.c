/* ports/host/scene_sampler.c: samplers for a scene's triangles. What reads triangles takes one,
 * what draws them asks for the level of each. */
#include <stdlib.h>

#include "scene_steps.h"

static bool is_power(uint16_t size)
{
    return (size & (size - 1)) == 0;
}

/* The wraps in the order of the state's words; [1] where the side is a power of two. */
static etch_texel_wrap *wrap_of(uint8_t word, uint16_t size)
{
    static etch_texel_wrap *const wraps[][2] = {
        {etch_texels_repeat, etch_texels_repeat_power},
        {etch_texels_clamp, etch_texels_clamp},
        {etch_texels_mirror, etch_texels_mirror_power},
    };

    return wraps[word][is_power(size)];
}

/* The filters in the order of the state's words; [1] fused, for opaque RGB565 that repeats in
 * powers of two. */
static etch_texel_filter *filter_of(uint8_t word, const struct etch_sampler *s)
{
    static etch_texel_filter *const filters[][2] = {
        {etch_filter_nearest, etch_filter_nearest_power},
        {etch_filter_linear, etch_filter_linear_power},
    };

    return filters[word][s->image.colors == etch_texels_rgb565 && s->image.alphas == NULL &&
                         s->wrap_u == etch_texels_repeat_power &&
                         s->wrap_v == etch_texels_repeat_power];
}

/* Chooses functions for the sampler's image. */
static void choose(struct etch_sampler *s, const struct etch_scene_sampling *sampling)
{
    s->wrap_u = wrap_of(sampling->wrap_u, s->image.width);
    s->wrap_v = wrap_of(sampling->wrap_v, s->image.height);
    s->filter = filter_of(sampling->filter, s);
}

/* Builds the levels of a texture once. */
static bool build(struct etch_scene_reader *reader, struct etch_scene_texture *texture)
{
    const struct etch_image *image = &texture->image;
    const uint32_t count = etch_mipmap_texels(image->width, image->height);

    if (texture->mipmap.count != 0) {
        return true;
    }
    texture->mipmap_color = malloc((size_t)count * sizeof *texture->mipmap_color + 1);
    texture->mipmap_alpha = malloc((size_t)count + 1);
    return (texture->mipmap_color != NULL && texture->mipmap_alpha != NULL &&
            etch_mipmap_build(&texture->mipmap, image, texture->mipmap_color, texture->mipmap_alpha,
                              count) == ETCH_OK) ||
           etch_text_fail(&reader->text, "out of memory");
}

bool etch_scene_take_sampler(struct etch_scene_reader *reader, struct etch_scene_sampling *sampling)
{
    const struct etch_scene_state *state = &reader->state;
    struct etch_scene_texture *texture = reader->texture;

    if (texture == NULL) {
        return etch_text_fail(&reader->text, "\"state tex\" is on, but there is no texture");
    }
    sampling->image = &texture->image;
    sampling->filter = state->filter;
    sampling->wrap_u = state->wrap;
    sampling->wrap_v = state->wrap_v != 0 ? (uint8_t)(state->wrap_v - 1) : state->wrap;
    sampling->mipmap = state->mipmap != 0 ? &texture->mipmap : NULL;
    return sampling->mipmap == NULL || build(reader, texture);
}

void etch_scene_sample_triangle(const struct etch_scene_sampling *sampling,
                                struct etch_sampler *sampler, struct etch_texture_vertex out[3],
                                const struct etch_texture_vertex *const v[3])
{
    const struct etch_mipmap *mipmap = sampling->mipmap;
    const uint8_t level = mipmap != NULL ? etch_mipmap_level(mipmap, v) : 0;

    sampler->image = mipmap != NULL ? mipmap->level[level] : *sampling->image;
    for (int i = 0; i < 3; i++) {
        if (mipmap != NULL) {
            etch_mipmap_vertex(&out[i], v[i], mipmap, level);
        } else {
            out[i] = *v[i];
        }
    }
    choose(sampler, sampling);
}

/* ---- names ------------------------------------------------------------------------------------
 */

typedef void function(void); /* any, as an address */

#define NAMED(part)                                                                                \
    {                                                                                              \
        (function *)(part), #part                                                                  \
    }

static const char *name_of(function *part)
{
    static const struct {
        function *part;
        const char *name;
    } parts[] = {
        NAMED(etch_filter_nearest), NAMED(etch_filter_nearest_power),
        NAMED(etch_filter_linear),  NAMED(etch_filter_linear_power),
        NAMED(etch_texels_repeat),  NAMED(etch_texels_repeat_power),
        NAMED(etch_texels_mirror),  NAMED(etch_texels_mirror_power),
        NAMED(etch_texels_clamp),   NAMED(etch_texels_rgb565),
        NAMED(etch_texels_index8),  NAMED(etch_texels_index4),
        NAMED(etch_texels_mask),    NAMED(etch_texels_alpha8),
        NAMED(etch_texels_alpha4),  NAMED(etch_mipmap_level),
    };

    for (size_t i = 0; i < sizeof parts / sizeof parts[0]; i++) {
        if (part == parts[i].part) {
            return parts[i].name;
        }
    }
    return NULL;
}

const char *etch_scene_sampling_name(const struct etch_scene_sampling *sampling, int part)
{
    struct etch_sampler s = {*sampling->image, NULL, NULL, NULL};

    choose(&s, sampling);
    const bool fused = s.filter == etch_filter_nearest_power ||
                       s.filter == etch_filter_linear_power;
    const bool same = s.wrap_u == s.wrap_v;
    function *const parts[ETCH_SCENE_SAMPLING_PARTS] = {
        (function *)s.filter,
        fused ? NULL : (function *)s.wrap_u,
        fused || same ? NULL : (function *)s.wrap_v,
        fused ? NULL : (function *)s.image.colors,
        (function *)s.image.alphas,
        sampling->mipmap != NULL ? (function *)etch_mipmap_level : NULL,
    };

    return name_of(parts[part]);
}
