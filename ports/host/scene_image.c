/* ports/host/scene_image.c: the image statement: pictures to the formats of core/draw/image.h.
 * scene.c finds it by name. */
#include "scene_image.h"

#include <string.h>

#include "ppm.h"
#include "scene_steps.h"

/* An image while it is read. */
struct reading {
    struct etch_scene_reader *reader;
    struct etch_scene_image *image;
    struct etch_ppm color;
    size_t width, height, stride;
    uint8_t *bytes[2], *alpha; /* planes; colours in both byte orders */
    size_t pitch, alpha_pitch; /* bytes a row */
    uint16_t palette[256], key, ink;
    size_t colors; /* of the palette */
    bool has_key;
};

static uint16_t pixel(const struct reading *r, size_t i)
{
    const uint8_t *const rgb = r->color.rgb + 3 * i;

    return etch_rgb565(rgb[0], rgb[1], rgb[2]);
}

static void put(uint8_t *row, size_t x, size_t bits, uint32_t value)
{
    row[x * bits / 8] |= (uint8_t)(value << x * bits % 8);
}

/* The number of a colour; a new one takes the next. */
static bool find(struct reading *r, uint16_t color, size_t *found)
{
    const struct etch_scene_format *const f = r->image->format;
    const size_t most = (size_t)1 << f->bits;

    if (f->key && color == r->key) {
        *found = 0;
        return true;
    }
    for (*found = f->key ? 1 : 0; *found < r->colors; ++*found) {
        if (r->palette[*found] == color) {
            return true;
        }
    }
    if (*found == most) {
        return etch_text_fail(&r->reader->text, "the picture has more than %zu colours", most);
    }
    r->palette[r->colors++] = color;
    return true;
}

static bool pack_colors(struct reading *r)
{
    const struct etch_scene_format *const f = r->image->format;

    r->pitch = r->stride * (size_t)f->bits / 8;
    r->bytes[0] = etch_scene_data(r->reader, r->pitch * r->height);
    r->bytes[1] = etch_scene_data(r->reader, r->pitch * r->height);
    r->colors = f->key ? 1 : 0;
    r->palette[0] = r->key;
    for (size_t i = 0; r->bytes[1] != NULL && i < r->width * r->height; i++) {
        const size_t row = i / r->width * r->pitch, x = i % r->width;
        size_t value = pixel(r, i);

        if (f->bits == 16) {
            const uint16_t swapped = etch_rgb565_swap((uint16_t)value);

            memcpy(r->bytes[0] + row + 2 * x, &(uint16_t){(uint16_t)value}, 2);
            memcpy(r->bytes[1] + row + 2 * x, &swapped, 2);
            continue;
        }
        if (!find(r, (uint16_t)value, &value)) {
            return false;
        }
        put(r->bytes[0] + row, x, (size_t)f->bits, (uint32_t)value);
        put(r->bytes[1] + row, x, (size_t)f->bits, (uint32_t)value);
    }
    return r->bytes[0] != NULL && r->bytes[1] != NULL;
}

/* How green a picture is. */
static bool pack_alpha(struct reading *r, const struct etch_ppm *from)
{
    const size_t bits = r->image->format->bits == 4 ? 4 : 8;

    if ((size_t)from->width != r->width || (size_t)from->height != r->height) {
        return etch_text_fail(&r->reader->text, "mask: not of the same size");
    }
    r->alpha_pitch = r->stride * bits / 8;
    r->alpha = etch_scene_data(r->reader, r->alpha_pitch * r->height);
    for (size_t i = 0; r->alpha != NULL && i < r->width * r->height; i++) {
        const uint32_t a = from->rgb[3 * i + 1];

        put(r->alpha + i / r->width * r->alpha_pitch, i % r->width, bits,
            bits == 4 ? (a * 15 + 127) / 255 : a);
    }
    return r->alpha != NULL;
}

static bool read_mask(struct reading *r)
{
    struct etch_ppm mask;
    const char *name;
    const char *path = etch_scene_path(r->reader, &name);
    bool ok;

    if (path == NULL || !etch_ppm_open(&mask, path, name, &r->reader->text)) {
        return false;
    }
    ok = pack_alpha(r, &mask);
    etch_ppm_close(&mask);
    return ok;
}

/* Rows of 16-bit units are compressed with the low byte first. */
static bool compress(struct reading *r, int order)
{
    struct etch_scene_image *const to = r->image;
    struct etch_rle_image *const packed = &to->packed[order];
    const int bits = to->format->bits;
    uint8_t *const bytes = etch_scene_data(r->reader, r->pitch * r->height + 1);

    packed->image = to->image[order];
    if (bytes == NULL) {
        return false;
    }
    for (size_t i = 0; r->bytes[order] != NULL && i < r->pitch * r->height; i++) {
        uint16_t unit;

        memcpy(&unit, r->bytes[order] + i / 2 * 2, 2 * (size_t)(bits == 16));
        bytes[i] = bits == 16 ? (uint8_t)(unit >> i % 2 * 8) : r->bytes[order][i];
    }
    packed->texels = (struct etch_rle_plane){.decode = to->format->mask ? NULL
                                                       : bits == 16     ? etch_rle_words
                                                                        : etch_rle_bytes,
                                             .unit_size = bits == 16 ? 2 : 1,
                                             .per_unit = (uint8_t)(bits < 8 ? 8 / bits : 1)};
    packed->alpha = (struct etch_rle_plane){.decode = to->format->alpha ? etch_rle_bytes : NULL,
                                            .unit_size = 1,
                                            .per_unit = bits == 4 ? 2 : 1};
    return (to->format->mask ||
            etch_scene_compress(r->reader, &packed->texels, bytes, r->pitch, r->height)) &&
           (!to->format->alpha ||
            etch_scene_compress(r->reader, &packed->alpha, r->alpha, r->alpha_pitch, r->height));
}

static bool describe(struct reading *r)
{
    struct etch_scene_image *const to = r->image;

    for (int order = 0; order < 2; order++) {
        uint16_t *const palette = etch_scene_data(r->reader, sizeof r->palette);

        if (palette == NULL) {
            return false;
        }
        r->palette[0] = to->format->mask ? r->ink : r->palette[0];
        for (size_t i = 0; i < 256; i++) {
            palette[i] = order == 1 ? etch_rgb565_swap(r->palette[i]) : r->palette[i];
        }
        to->image[order] = (struct etch_image){
            .colors = to->format->colors,
            .alphas = to->format->alphas,
            .texels = to->format->mask ? r->alpha : r->bytes[order],
            .palette = palette,
            .alpha = r->alpha != NULL ? r->alpha : r->bytes[order],
            .width = (uint16_t)r->width,
            .height = (uint16_t)r->height,
            .stride = (uint16_t)r->stride,
        };
        if (to->compressed && !compress(r, order)) {
            return false;
        }
    }
    to->line = etch_scene_data(r->reader, r->pitch + r->alpha_pitch + 2);
    return to->line != NULL;
}

/* [key R G B] [color R G B] [mask FILE] [rle] */
static bool read_options(struct reading *r)
{
    struct etch_scene_reader *const reader = r->reader;
    uint8_t rgb[3];

    while (etch_text_more(&reader->text)) {
        if (etch_scene_take(reader, "rle")) {
            r->image->compressed = true;
        } else if (etch_scene_take(reader, "mask")) {
            if (!read_mask(r)) {
                return false;
            }
        } else if (etch_scene_take(reader, "key")) {
            if (!etch_scene_read_rgb(reader, rgb)) {
                return false;
            }
            r->key = etch_rgb565(rgb[0], rgb[1], rgb[2]);
            r->has_key = true;
        } else if (etch_scene_take(reader, "color")) {
            if (!etch_scene_read_rgb(reader, rgb)) {
                return false;
            }
            r->ink = etch_rgb565(rgb[0], rgb[1], rgb[2]);
        } else {
            return true; /* a word too many is the line's error */
        }
    }
    return true;
}

static bool read_picture(struct reading *r)
{
    const struct etch_scene_format *const f = r->image->format;
    const size_t per_byte = f->bits < 8 ? 8 / (size_t)f->bits : 1;
    struct etch_text *const text = &r->reader->text;

    r->width = (size_t)r->color.width, r->height = (size_t)r->color.height;
    r->stride = (r->width + per_byte - 1) / per_byte * per_byte;
    if (!read_options(r)) {
        return false;
    }
    if (f->mask && r->alpha == NULL && !pack_alpha(r, &r->color)) {
        return false;
    }
    if (f->key != r->has_key) {
        return etch_text_fail(text, "%s %s a key", f->name, f->key ? "needs" : "has not");
    }
    if (f->alpha != (r->alpha != NULL)) {
        return etch_text_fail(text, "%s %s a mask", f->name, f->alpha ? "needs" : "has not");
    }
    return (f->mask || pack_colors(r)) && describe(r);
}

/* Takes the name of a format. */
static const struct etch_scene_format *read_format(struct etch_scene_reader *reader)
{
    struct etch_word word;

    if (!etch_text_word(&reader->text, "format", &word)) {
        return NULL;
    }
    for (const struct etch_scene_format *f = etch_scene_formats; f->name != NULL; f++) {
        if (etch_word_is(word, f->name)) {
            return f;
        }
    }
    (void)etch_text_fail(&reader->text, "format: \"%s\" is unknown", etch_word_show(word).text);
    return NULL;
}

static bool read_image(struct etch_scene_reader *reader,
                       const struct etch_scene_statement *statement)
{
    struct reading r = {.reader = reader, .ink = UINT16_MAX};
    const struct etch_scene_format *const format = read_format(reader);
    const char *path, *name;
    bool ok;

    (void)statement;
    r.image = format != NULL ? etch_scene_data(reader, sizeof *r.image) : NULL;
    path = r.image != NULL ? etch_scene_path(reader, &name) : NULL;
    if (path == NULL || !etch_ppm_open(&r.color, path, name, &reader->text)) {
        return false;
    }
    r.image->format = format;
    reader->image = r.image;
    ok = read_picture(&r);
    etch_ppm_close(&r.color);
    return ok;
}

const struct etch_scene_statement etch_scene_image_statements[] = {
    {"image", read_image, NULL, NULL, NULL},
    {NULL, NULL, NULL, NULL, NULL},
};
