/* draw/image_rle.h: run-length compressed images in flash, decoded a row at a time.
 *
 * A plane (texels, or alpha) is rows of units: 16-bit for RGB565 (low byte first), bytes for
 * everything else, packed as draw/image.h says, each row from a new byte on. A row is packets:
 *
 *      0 .. 127      c      c + 1 units follow, taken as they are
 *      128 .. 255    c      one unit follows, taken c - 126 times
 *
 * Packets end with their row. `rows` has the offset of every 2^rows_shift-th row: a strip or a clip
 * begins there and passes over the rows between, packet by packet, without writing. So a strip
 * costs its own rows and less than 2^rows_shift others; the table costs 4 bytes for each
 * 2^rows_shift rows. Decoding takes some 30 instructions a packet and 4 to 6 a byte on Cortex-M0+,
 * and then the row function.
 *
 * Any data is legal. A row whose data ends too soon is drawn up to there; a packet that goes on
 * beyond its row is cut, and the next row begins behind it; a row whose offset is not in the data
 * is not drawn. Nothing outside data[0 .. size - 1], the rows' table, the palette (2^bits colours:
 * etch-image writes so many) and the caller's line is read or written. Source: PackBits (Apple,
 * Technical Note TN1023, 1996), with other numbers.
 */
#ifndef ETCH_DRAW_IMAGE_RLE_H
#define ETCH_DRAW_IMAGE_RLE_H

#include "image.h"

/* Where the next packet begins, and where the data ends. */
struct etch_rle_cursor {
    const uint8_t *at, *end;
};

/* Passes over one row of `units` units and writes the first `keep` of them, at most `units`, to
 * `out`. Returns how many it wrote. */
typedef uint16_t etch_rle_decoder(struct etch_rle_cursor *cursor, void *out, uint16_t keep,
                                  uint16_t units);
etch_rle_decoder etch_rle_bytes;
etch_rle_decoder etch_rle_words;

struct etch_rle_plane {
    etch_rle_decoder *decode; /* NULL: the image has no such plane */
    const uint8_t *data;
    const uint32_t *rows; /* offsets of rows 0, 2^rows_shift, .. */
    uint32_t size;        /* of data, bytes */
    uint16_t units;       /* in a row */
    uint8_t unit_size;    /* bytes: 1, for etch_rle_words 2 */
    uint8_t per_unit;     /* texels in a unit: 1, 2, 4 or 8 */
    uint8_t rows_shift;   /* 0 .. 15 */
};

struct etch_rle_image {
    struct etch_image image; /* but texels and alpha, which are NULL */
    struct etch_rle_plane texels, alpha;
};

struct etch_rle_style {
    const struct etch_rle_image *image;
    etch_image_row *row; /* that of the same image uncompressed */
    uint8_t opacity;
    uint16_t *line; /* the caller's: etch_rle_line_size bytes */
};

/* Bytes of one row of a plane, and of all. */
ETCH_INLINE uint32_t etch_rle_plane_size(const struct etch_rle_plane *plane)
{
    return plane->decode == NULL ? 0 : (uint32_t)plane->units * plane->unit_size;
}

ETCH_INLINE uint32_t etch_rle_line_size(const struct etch_rle_image *image)
{
    return etch_rle_plane_size(&image->texels) + etch_rle_plane_size(&image->alpha);
}

/* The image with its upper left pixel at (x, y): the pixels of etch_image_draw. */
void etch_rle_draw(const struct etch_surface *s, const struct etch_rle_style *style, int16_t x,
                   int16_t y);

#endif
