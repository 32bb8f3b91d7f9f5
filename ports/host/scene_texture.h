/* ports/host/scene_texture.h: the textures of a scene, for what reads and what draws them. */
#ifndef ETCH_HOST_SCENE_TEXTURE_H
#define ETCH_HOST_SCENE_TEXTURE_H

#include "../../core/fragment/mipmap.h"
#include "../../core/fragment/sampler.h"
#include "scene_pipeline.h"

struct etch_scene_reader;

/* All pointers are from malloc or NULL. */
struct etch_scene_texture {
    struct etch_image image; /* what samplers read: the memory below */
    uint16_t *color;         /* RGB565, a texel each */
    uint8_t *index;          /* of palette formats, instead */
    uint8_t *alpha;          /* a byte a texel, or a byte a colour of the palette */
    uint16_t palette[256];

    uint16_t *texel; /* as `color`, in the scene's byte order once it is read, for fused kernels */

    struct etch_mipmap mipmap; /* count 0 until a triangle wants it */
    uint16_t *mipmap_color;
    uint8_t *mipmap_alpha;
};

/* What a triangle is drawn with. */
struct etch_scene_sampling {
    const struct etch_image *image;   /* the whole texture */
    const struct etch_mipmap *mipmap; /* NULL: off */
    uint8_t filter, wrap_u, wrap_v;   /* as in struct etch_scene_state */
};

/* Describes the latest texture for the state as it stands: filter, wraps, mipmap. False, with an
 * error set, without a texture or memory. */
bool etch_scene_take_sampler(struct etch_scene_reader *reader,
                             struct etch_scene_sampling *sampling);

/* For each triangle, before it is drawn: the sampler of its mipmap level, and its vertices with
 * coordinates in texels of that level. Without mipmap both are copies. */
void etch_scene_sample_triangle(const struct etch_scene_sampling *sampling,
                                struct etch_sampler *sampler, struct etch_texture_vertex out[3],
                                const struct etch_texture_vertex *const v[3]);

/* The names of the functions that a sampler of the whole texture uses, for --needs; NULL for parts
 * that it does not have. */
#define ETCH_SCENE_SAMPLING_PARTS 6
const char *etch_scene_sampling_name(const struct etch_scene_sampling *sampling, int part);

/* True if the fused kernels of fragment/texture.h can draw the latest texture, repeated and
 * nearest, as far as colours go: not a palette, and of a size that they take. */
bool etch_scene_texture_is_plain(const struct etch_scene_reader *reader);

/* Reads what follows `texture` into an empty one. */
bool etch_scene_read_texels(struct etch_scene_reader *reader, struct etch_scene_texture *texture);

#endif
