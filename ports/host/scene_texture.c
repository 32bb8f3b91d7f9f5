/* ports/host/scene_texture.c: the texture statement. scene.c finds it by name. Textures are kept
 * as RGB565; alpha is checked and dropped, because nothing that can be drawn yet reads it. */
#include <stdlib.h>

#include "array.h"
#include "ppm.h"
#include "scene_steps.h"

/* RRGGBBAA to a colour. */
static bool read_texel(struct etch_word word, uint16_t *color)
{
    uint32_t rgba = 0;

    for (size_t i = 0; i < word.size; i++) {
        const char c = word.text[i];
        const int digit = c >= '0' && c <= '9'   ? c - '0'
                          : c >= 'a' && c <= 'f' ? c - 'a' + 10
                          : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                                 : -1;

        if (digit < 0 || word.size != 8) {
            return false;
        }
        rgba = (rgba & 0x0FFFFFFF) << 4 | (uint32_t)digit;
    }
    *color = etch_rgb565((uint8_t)(rgba >> 24), (uint8_t)(rgba >> 16 & 0xFF),
                         (uint8_t)(rgba >> 8 & 0xFF));
    return true;
}

/* W H RRGGBBAA .. */
static bool read_texels(struct etch_scene_reader *reader, struct etch_scene_texture *texture)
{
    struct etch_word word;
    int64_t width, height;
    size_t capacity = 0;

    if (!etch_text_integer(&reader->text, "width", 1, 32767, &width) ||
        !etch_text_integer(&reader->text, "height", 1, 32767, &height)) {
        return false;
    }
    texture->width = (int32_t)width;
    texture->height = (int32_t)height;
    for (size_t i = 0; i < (size_t)(width * height); i++) {
        void *texels = texture->texel;

        if (!etch_array_grow(&texels, &capacity, i, sizeof *texture->texel)) {
            return etch_text_fail(&reader->text, "out of memory");
        }
        texture->texel = texels;
        if (!etch_text_word(&reader->text, "texel", &word)) {
            return false;
        }
        if (!read_texel(word, &texture->texel[i])) {
            return etch_text_fail(&reader->text, "texel %zu: \"%s\" is not RRGGBBAA", i,
                                  etch_word_show(word).text);
        }
    }
    return true;
}

/* ppm FILE */
static bool read_ppm(struct etch_scene_reader *reader, struct etch_scene_texture *texture)
{
    struct etch_ppm ppm;
    const char *name;
    const char *path = etch_scene_path(reader, &name);
    size_t count;

    if (path == NULL || !etch_ppm_open(&ppm, path, name, &reader->text)) {
        return false;
    }
    texture->width = ppm.width;
    texture->height = ppm.height;
    count = (size_t)ppm.width * (size_t)ppm.height;
    texture->texel = malloc(count * sizeof *texture->texel);
    for (size_t i = 0; texture->texel != NULL && i < count; i++) {
        const uint8_t *rgb = ppm.rgb + 3 * i;

        texture->texel[i] = etch_rgb565(rgb[0], rgb[1], rgb[2]);
    }
    etch_ppm_close(&ppm);
    return texture->texel != NULL || etch_text_fail(&reader->text, "out of memory");
}

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

bool etch_scene_read_texture(struct etch_scene_reader *reader,
                             const struct etch_scene_statement *statement)
{
    struct etch_scene_texture *texture = new_texture(reader);

    (void)statement;
    reader->texture = texture;
    return texture != NULL && (etch_scene_take(reader, "ppm") ? read_ppm(reader, texture)
                                                              : read_texels(reader, texture));
}

bool etch_scene_take_texture(struct etch_scene_reader *reader, struct etch_texture *texture)
{
    const struct etch_scene_texture *from = reader->texture;

    if (from == NULL) {
        return etch_text_fail(&reader->text, "\"state tex\" is on, but there is no texture");
    }
    return etch_texture_init(texture, from->texel, (uint16_t)from->width, (uint16_t)from->height) ==
               ETCH_OK ||
           etch_text_fail(
               &reader->text,
               "drawing with a texture of %d x %d is not supported yet: sides are powers "
               "of two, the width 4096 at most, 65536 texels in all",
               (int)from->width, (int)from->height);
}

void etch_scene_textures_finish(struct etch_scene *scene)
{
    for (size_t i = 0; scene->format == ETCH_FORMAT_RGB565_SWAPPED && i < scene->texture_count;
         i++) {
        const struct etch_scene_texture *texture = scene->texture[i];
        const size_t count = (size_t)texture->width * (size_t)texture->height;

        for (size_t k = 0; k < count; k++) {
            texture->texel[k] = etch_rgb565_swap(texture->texel[k]);
        }
    }
}

void etch_scene_textures_free(struct etch_scene *scene)
{
    for (size_t i = 0; i < scene->texture_count; i++) {
        free(scene->texture[i]->texel);
        free(scene->texture[i]);
    }
    free(scene->texture);
}
