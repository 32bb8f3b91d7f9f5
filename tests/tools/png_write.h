/* tests/tools/png_write.h: writes a picture as an uncompressed PNG file. */
#ifndef TESTS_TOOLS_PNG_WRITE_H
#define TESTS_TOOLS_PNG_WRITE_H

#include <stdbool.h>

#include "png_read.h"

bool png_write(const struct picture *p, const char *path);

/* The checksum of PNG chunks. Source: RFC 2083. */
uint32_t png_crc32(const uint8_t *p, size_t n);

#endif
