/* ports/tools/image_format.h: the formats that etch-image makes, and an image in one of them. */
#ifndef ETCH_TOOLS_IMAGE_FORMAT_H
#define ETCH_TOOLS_IMAGE_FORMAT_H

#include "image_source.h"

enum image_kind {
    IMAGE_COLORS,  /* RGB565 */
    IMAGE_PALETTE, /* bits a texel */
    IMAGE_MASK
};

struct image_format {
    const char *name;
    enum image_kind kind;
    int bits;
    bool key;                          /* some texels are left out: a key colour, index 0 */
    bool alpha;                        /* with a plane of 8 bits */
    const char *row, *colors, *alphas; /* functions of etch; NULL: none */
};

extern const struct image_format image_formats[]; /* ends with a name of NULL */

struct image_options {
    bool dither, swapped, sampled, compressed;
    bool has_key;
    uint8_t key[3], background[3], ink[3];
    int rows_shift;
};

struct plane {
    uint8_t *bytes; /* 16-bit units: low byte first */
    size_t size;
    int pitch;     /* bytes a row */
    int unit_size; /* 1 or 2 */
    uint32_t *rows;
};

struct packed {
    const struct image_format *format;
    int width, height, stride;
    struct plane texels, alpha; /* size 0: none */
    uint16_t palette[256];
    int colors;
    uint8_t *shown; /* RGBA, what is drawn */
};

/* Brings a picture to a format. */
void image_pack(struct packed *out, const struct picture *p, const struct image_format *format,
                const struct image_options *options);

/* Packs a plane by runs, as draw/image_rle.h says. */
void image_compress(struct plane *plane, int height, int rows_shift);

/* Up to `most` colours that stand for `count` pixels of RGB: by median cut, then moved to the means
 * of the pixels that are nearest to them. Returns how many. */
int image_palette(uint8_t (*palette)[3], int most, const uint8_t (*pixel)[3], size_t count);

/* The number of the palette's colour nearest to `rgb`. */
int image_nearest(const uint8_t (*palette)[3], int colors, const int rgb[3]);

/* Bytes in flash without the struct. */
size_t image_size(const struct packed *packed, const struct image_options *options);

/* How far what is drawn is from the picture, in 8-bit steps, over all channels that are drawn. */
struct image_error {
    double mean, psnr; /* psnr: dB, infinite for no error */
    int most;
};
struct image_error image_compare(const struct packed *packed, const struct picture *p,
                                 const struct image_options *options);

/* The C file. `core`: how it includes core; `from`: a comment. */
void image_write(FILE *out, const struct packed *packed, const struct image_options *options,
                 const char *name, const char *core, const char *from);

/* What a pixel is to look like in a format without alpha: over the background. */
static inline uint8_t image_over(uint8_t c, uint8_t alpha, uint8_t background)
{
    return (uint8_t)((c * alpha + background * (255 - alpha) + 127) / 255);
}

#endif
