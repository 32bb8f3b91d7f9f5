/* ports/host/scene_sampler.c: samplers for a scene's triangles. What reads triangles takes one, what
 * draws them asks for the level of each. */
#include <stdlib.h>

#include "scene_steps.h"

/* The wraps in the order of the state's words; [1] where the side is a power of two. */
static etch_texel_wrap *wrap_of(uint8_t word, uint16_t size)
{
    static etch_texel_wrap *const wraps[][2] = {
        {etch_texels_repeat, etch_texels_repeat_power},
        {etch_texels_clamp, etch_texels_clamp},
        {etch_texels_mirror, etch_texels_mirror_power},
    };

    return wraps[word][(size & (size - 1)) == 0];
}

static etch_texel_filter *filter_of(const struct etch_scene_state *state)
{
    return state->filter == 0 ? etch_filter_nearest : etch_filter_linear;
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
    sampling->sampler = (struct etch_sampler){texture->image, filter_of(state), NULL, NULL};
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

    *sampler = sampling->sampler;
    for (int i = 0; i < 3; i++) {
        if (mipmap != NULL) {
            etch_mipmap_vertex(&out[i], v[i], mipmap, level);
        } else {
            out[i] = *v[i];
        }
    }
    if (mipmap != NULL) {
        sampler->image = mipmap->level[level];
    }
    sampler->wrap_u = wrap_of(sampling->wrap_u, sampler->image.width);
    sampler->wrap_v = wrap_of(sampling->wrap_v, sampler->image.height);
}
