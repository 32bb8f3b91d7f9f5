/* ports/host/dump.h: frames to picture files.
 *
 * All writers send rows top to bottom to a stream and return false if it took an error (errno
 * says which) or memory ran out. 16-bit pixels become 8-bit channels by bit replication. What
 * is written does not depend on the host's byte order. */
#ifndef ETCH_HOST_DUMP_H
#define ETCH_HOST_DUMP_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

/* A plane of 16-bit elements: colours, depths, or stencil values. */
struct etch_plane16 {
    const uint16_t *data;
    int32_t width, height, stride; /* 1 .. 32767; stride in elements */
    bool swapped;                  /* colours in rgb565_swapped */
};

typedef bool etch_dump(FILE *file, const struct etch_plane16 *plane);

etch_dump etch_dump_ppm; /* P6, 8 bits a channel */
etch_dump etch_dump_png; /* 8-bit RGB, compressed */

/* width * height 16-bit words, little-endian, row 0 first, colours as plain rgb565. */
etch_dump etch_dump_raw;

/* width * height bytes, row 0 first: the elements, which are below 256. */
etch_dump etch_dump_bytes;

/* Row y as 3 * width bytes R G B. */
void etch_dump_row(const struct etch_plane16 *plane, int32_t y, uint8_t *rgb);

#endif
