/* ports/tools/image_source.h: pictures that etch-image reads. */
#ifndef ETCH_TOOLS_IMAGE_SOURCE_H
#define ETCH_TOOLS_IMAGE_SOURCE_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

#define IMAGE_SIDE 32767 /* most columns and rows */

struct picture {
    int width, height;
    bool alpha;    /* the file says what is transparent */
    uint8_t *rgba; /* 4 bytes a pixel, row 0 first */
};

/* Says what is wrong on stderr and ends the program with status 2. */
_Noreturn void image_fail(const char *what, const char *detail);

void *image_memory(size_t size);

/* PPM and PGM (P6, P5; Netpbm formats) or PNG, by what the file begins with. */
void image_read(struct picture *p, const char *path);

/* An empty picture; fails if a side is not 1 .. IMAGE_SIDE. */
void image_open(struct picture *p, long width, long height, const char *path);

/* Of a file that begins as PNG. In image_png.c, or image_no_png.c where there is no libpng. */
void image_read_png(struct picture *p, FILE *file, const char *path);

#endif
