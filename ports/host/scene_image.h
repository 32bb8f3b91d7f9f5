/* ports/host/scene_image.h: the images of a scene, for what reads and what draws them. */
#ifndef ETCH_HOST_SCENE_IMAGE_H
#define ETCH_HOST_SCENE_IMAGE_H

#include "../../core/draw/image_rle.h"

struct etch_scene_reader;

struct etch_scene_row {
    etch_image_row *row;
    const char *name;
};

struct etch_scene_format {
    const char *name;
    int bits; /* of a texel; of masks, of alpha */
    bool key, alpha, mask;
    etch_texel_colors *colors;
    etch_texel_alphas *alphas;
    /* full opacity, less; byte-swapped. Without a row there is no such way to draw it. */
    struct etch_scene_row full[2], fade[2];
};

extern const struct etch_scene_format etch_scene_formats[]; /* ends with a name of NULL */

/* One image in both byte orders: [1] is swapped. All memory is the scene's. */
struct etch_scene_image {
    const struct etch_scene_format *format;
    struct etch_image image[2];
    struct etch_rle_image packed[2]; /* if it is compressed */
    bool compressed;
    uint16_t *line; /* room for one row, decoded */
};

struct etch_scene_showing;

/* Draws one statement; order: 1 in byte-swapped pixels. */
typedef void etch_scene_show(const struct etch_surface *s, const struct etch_scene_showing *w,
                             int order);
etch_scene_show etch_scene_show_blit, etch_scene_show_stretch, etch_scene_show_nine;
etch_scene_show etch_scene_show_spin, etch_scene_show_cursor, etch_scene_show_xor;
etch_scene_show etch_scene_show_copy, etch_scene_show_scroll;

/* A statement that draws an image. */
struct etch_scene_showing {
    const struct etch_scene_image *image;
    etch_scene_show *show;
    int16_t at[8];
    struct etch_map_place place;
    struct etch_rect part;
    uint8_t opacity, rgb[3];
    uint8_t turn;
    bool linear;
};

/* Compresses rows of `pitch` bytes into the scene's memory; false with an error set. */
bool etch_scene_compress(struct etch_scene_reader *reader, struct etch_rle_plane *plane,
                         const uint8_t *bytes, size_t pitch, size_t height);

#endif
