/* tests/tools/png_read.h: reads the PNG files that the simulator writes, written apart from its
 * writer, so that a golden picture proves both. */
#ifndef TESTS_TOOLS_PNG_READ_H
#define TESTS_TOOLS_PNG_READ_H

#include <stddef.h>
#include <stdint.h>

struct picture {
    uint32_t width, height;
    uint8_t *rgb; /* width * height * 3, from malloc */
};

/* Reads an 8-bit RGB picture without interlacing. Returns NULL or what is wrong. */
const char *png_read(struct picture *p, const char *path);

/* Decompresses a zlib stream of n bytes into exactly `size` bytes. Returns NULL or what is wrong.
 * Source: RFC 1950, RFC 1951. */
const char *inflate(uint8_t *out, size_t size, const uint8_t *in, size_t n);

#endif
