/* ports/host/scene_texels.c: the forms of the texture statement. scene_texture.c calls it. */
#include <stdlib.h>

#include "array.h"
#include "ppm.h"
#include "scene_steps.h"

/* One colour as it is written: RRGGBBAA, or RRGGBB where the whole texture is opaque. */
struct written {
    uint16_t color;
    uint8_t alpha;
};

static int digit_of(char c)
{
    return c >= '0' && c <= '9'   ? c - '0'
           : c >= 'a' && c <= 'f' ? c - 'a' + 10
           : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                  : -1;
}

static bool parse(struct etch_word word, size_t digits, struct written *to)
{
    uint32_t rgba = 0;

    for (size_t i = 0; i < word.size; i++) {
        if (digit_of(word.text[i]) < 0 || word.size != digits) {
            return false;
        }
        rgba = (rgba & 0x0FFFFFFF) << 4 | (uint32_t)digit_of(word.text[i]);
    }
    rgba = digits == 6 ? rgba << 8 | 0xFF : rgba;
    to->color = etch_rgb565((uint8_t)(rgba >> 24), (uint8_t)(rgba >> 16 & 0xFF),
                            (uint8_t)(rgba >> 8 & 0xFF));
    to->alpha = (uint8_t)(rgba & 0xFF);
    return word.size == digits;
}

/* The colour number i of a texture; the first decides how many digits all have. */
static bool read_color(struct etch_scene_reader *reader, const char *name, size_t i, size_t *digits,
                       struct written *to)
{
    struct etch_word word;

    if (!etch_text_word(&reader->text, name, &word)) {
        return false;
    }
    if (i == 0) {
        *digits = word.size == 6 ? 6 : 8;
    }
    return parse(word, *digits, to) ||
           etch_text_fail(&reader->text, "%s %zu: \"%s\" is not %s", name, i,
                          etch_word_show(word).text, *digits == 6 ? "RRGGBB" : "RRGGBBAA");
}

/* W H */
static bool read_size(struct etch_scene_reader *reader, struct etch_image *image)
{
    int64_t width, height;

    if (!etch_text_integer(&reader->text, "width", 1, 32767, &width) ||
        !etch_text_integer(&reader->text, "height", 1, 32767, &height)) {
        return false;
    }
    image->width = image->stride = (uint16_t)width;
    image->height = (uint16_t)height;
    return true;
}

/* W H RRGGBBAA .. */
static bool read_colors(struct etch_scene_reader *reader, struct etch_scene_texture *texture)
{
    size_t color_capacity = 0, alpha_capacity = 0, digits = 8;
    struct written texel = {0, 0};

    if (!read_size(reader, &texture->image)) {
        return false;
    }
    for (size_t i = 0; i < (size_t)texture->image.width * texture->image.height; i++) {
        void *colors = texture->color, *alphas = texture->alpha;
        bool room = etch_array_grow(&colors, &color_capacity, i, sizeof *texture->color);

        texture->color = colors;
        room = etch_array_grow(&alphas, &alpha_capacity, i, 1) && room;
        texture->alpha = alphas;
        if (!room) {
            return etch_text_fail(&reader->text, "out of memory");
        }
        if (!read_color(reader, "texel", i, &digits, &texel)) {
            return false;
        }
        texture->color[i] = texel.color;
        texture->alpha[i] = texel.alpha;
    }
    texture->image.colors = etch_texels_rgb565;
    texture->image.alphas = digits == 8 ? etch_texels_mask : NULL;
    return true;
}

/* W H COUNT RRGGBBAA .. INDEX ..; 4 bits: two texels a byte, even ones in the low half */
static bool read_indexes(struct etch_scene_reader *reader, struct etch_scene_texture *texture,
                         int bits)
{
    size_t capacity = 0, digits = 8;
    int64_t count, index;

    if (!read_size(reader, &texture->image) ||
        !etch_text_integer(&reader->text, "count of colours", 1, 1 << bits, &count)) {
        return false;
    }
    texture->alpha = calloc(256, 1);
    for (size_t i = 0; texture->alpha != NULL && i < (size_t)count; i++) {
        struct written color = {0, 0};

        if (!read_color(reader, "colour", i, &digits, &color)) {
            return false;
        }
        texture->palette[i] = color.color;
        texture->alpha[i] = color.alpha;
    }
    for (size_t i = 0; i < (size_t)texture->image.width * texture->image.height; i++) {
        void *indexes = texture->index;

        if (texture->alpha == NULL || !etch_array_grow(&indexes, &capacity, i, 1)) {
            return etch_text_fail(&reader->text, "out of memory");
        }
        texture->index = indexes;
        if (!etch_text_integer(&reader->text, "texel", 0, count - 1, &index)) {
            return false;
        }
        if (bits == 8) {
            texture->index[i] = (uint8_t)index;
        } else if (i % 2 == 0) {
            texture->index[i / 2] = (uint8_t)index;
        } else {
            texture->index[i / 2] |= (uint8_t)(index << 4);
        }
    }
    texture->image.colors = bits == 8 ? etch_texels_index8 : etch_texels_index4;
    texture->image.alphas = digits == 6 ? NULL
                            : bits == 8 ? etch_texels_alpha8
                                        : etch_texels_alpha4;
    return true;
}

/* FILE, as a mask: how green it is */
static bool read_mask(struct etch_scene_reader *reader, struct etch_scene_texture *texture)
{
    const struct etch_image *image = &texture->image;
    struct etch_ppm ppm;
    const char *name;
    const char *path = etch_scene_path(reader, &name);
    bool ok;

    if (path == NULL || !etch_ppm_open(&ppm, path, name, &reader->text)) {
        return false;
    }
    ok = ppm.width == image->width && ppm.height == image->height;
    if (!ok) {
        (void)etch_text_fail(&reader->text, "%s is %d x %d, not %d x %d as the texture", name,
                             (int)ppm.width, (int)ppm.height, image->width, image->height);
    } else {
        const size_t count = (size_t)ppm.width * (size_t)ppm.height;

        texture->alpha = malloc(count);
        for (size_t i = 0; texture->alpha != NULL && i < count; i++) {
            texture->alpha[i] = ppm.rgb[3 * i + 1];
        }
        ok = texture->alpha != NULL || etch_text_fail(&reader->text, "out of memory");
    }
    etch_ppm_close(&ppm);
    return ok;
}

/* FILE [mask FILE] */
static bool read_ppm(struct etch_scene_reader *reader, struct etch_scene_texture *texture)
{
    struct etch_image *image = &texture->image;
    struct etch_ppm ppm;
    const char *name;
    const char *path = etch_scene_path(reader, &name);
    size_t count;

    if (path == NULL || !etch_ppm_open(&ppm, path, name, &reader->text)) {
        return false;
    }
    image->width = image->stride = (uint16_t)ppm.width;
    image->height = (uint16_t)ppm.height;
    image->colors = etch_texels_rgb565;
    count = (size_t)ppm.width * (size_t)ppm.height;
    texture->color = malloc(count * sizeof *texture->color);
    for (size_t i = 0; texture->color != NULL && i < count; i++) {
        const uint8_t *rgb = ppm.rgb + 3 * i;

        texture->color[i] = etch_rgb565(rgb[0], rgb[1], rgb[2]);
    }
    etch_ppm_close(&ppm);
    if (texture->color == NULL) {
        return etch_text_fail(&reader->text, "out of memory");
    }
    if (!etch_scene_take(reader, "mask")) {
        return true;
    }
    image->alphas = etch_texels_mask;
    return read_mask(reader, texture);
}

bool etch_scene_read_texels(struct etch_scene_reader *reader, struct etch_scene_texture *texture)
{
    return etch_scene_take(reader, "ppm")    ? read_ppm(reader, texture)
           : etch_scene_take(reader, "pal8") ? read_indexes(reader, texture, 8)
           : etch_scene_take(reader, "pal4") ? read_indexes(reader, texture, 4)
                                             : read_colors(reader, texture);
}
