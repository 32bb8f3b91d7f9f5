/* ports/host/scene_texture.c: the texture statement, and the life of what it reads. scene.c finds
 * it by name. */
#include <stdlib.h>
#include <string.h>

#include "array.h"
#include "scene_steps.h"

/* An empty texture that the scene owns. */
static struct etch_scene_texture *new_texture(struct etch_scene_reader *reader)
{
    struct etch_scene *scene = reader->scene;
    struct etch_scene_texture *texture = calloc(1, sizeof *texture);
    void *list = scene->texture;

    if (texture == NULL || !etch_array_grow(&list, &scene->texture_capacity, scene->texture_count,
                                            sizeof *scene->texture)) {
        free(texture);
        (void)etch_text_fail(&reader->text, "out of memory");
        return NULL;
    }
    scene->texture = list;
    scene->texture[scene->texture_count++] = texture;
    return texture;
}

static size_t texels_of(const struct etch_scene_texture *texture)
{
    return (size_t)texture->image.width * texture->image.height;
}

/* Points the image at what was read, and copies the texels that fused kernels read. */
static bool describe(struct etch_scene_reader *reader, struct etch_scene_texture *texture)
{
    const size_t size = texels_of(texture) * sizeof *texture->texel;

    texture->image.texels = texture->index != NULL ? (const void *)texture->index : texture->color;
    texture->image.palette = texture->palette;
    texture->image.alpha = texture->alpha;
    if (texture->index != NULL) {
        return true;
    }
    texture->texel = malloc(size);
    if (texture->texel == NULL) {
        return etch_text_fail(&reader->text, "out of memory");
    }
    memcpy(texture->texel, texture->color, size);
    return true;
}

bool etch_scene_read_texture(struct etch_scene_reader *reader,
                             const struct etch_scene_statement *statement)
{
    struct etch_scene_texture *texture = new_texture(reader);

    (void)statement;
    reader->texture = texture;
    return texture != NULL && etch_scene_read_texels(reader, texture) && describe(reader, texture);
}

bool etch_scene_texture_is_plain(const struct etch_scene_reader *reader)
{
    const struct etch_scene_texture *from = reader->texture;
    struct etch_texture texture;

    return from != NULL && etch_texture_init(&texture, from->texel, from->image.width,
                                             from->image.height) == ETCH_OK;
}

bool etch_scene_take_texture(struct etch_scene_reader *reader, struct etch_texture *texture)
{
    const struct etch_scene_texture *from = reader->texture;

    if (from == NULL) {
        return etch_text_fail(&reader->text, "\"state tex\" is on, but there is no texture");
    }
    return etch_texture_init(texture, from->texel, from->image.width, from->image.height) ==
               ETCH_OK ||
           etch_text_fail(
               &reader->text,
               "drawing with a texture of %d x %d is not supported yet: sides are powers "
               "of two, the width 4096 at most, 65536 texels in all",
               from->image.width, from->image.height);
}

void etch_scene_textures_finish(struct etch_scene *scene)
{
    for (size_t i = 0; scene->format == ETCH_FORMAT_RGB565_SWAPPED && i < scene->texture_count;
         i++) {
        struct etch_scene_texture *texture = scene->texture[i];

        for (size_t k = 0; texture->texel != NULL && k < texels_of(texture); k++) {
            texture->texel[k] = etch_rgb565_swap(texture->texel[k]);
        }
    }
}

void etch_scene_textures_free(struct etch_scene *scene)
{
    for (size_t i = 0; i < scene->texture_count; i++) {
        struct etch_scene_texture *texture = scene->texture[i];

        free(texture->color);
        free(texture->index);
        free(texture->alpha);
        free(texture->texel);
        free(texture->mipmap_color);
        free(texture->mipmap_alpha);
        free(texture);
    }
    free(scene->texture);
}
