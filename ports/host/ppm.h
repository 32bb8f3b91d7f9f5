/* ports/host/ppm.h: pictures from PPM files. */
#ifndef ETCH_HOST_PPM_H
#define ETCH_HOST_PPM_H

#include "text.h"

struct etch_ppm {
    int32_t width, height; /* 1 .. 32767 */
    const uint8_t *rgb;    /* 3 * width * height bytes, row 0 first */
    char *data;            /* the file, from malloc, which rgb points into */
};

/* Reads a binary PPM (P6) of 8 bits a channel: maxval 255, one picture, nothing behind it.
 * Comments, from `#` to the end of the line, may stand anywhere in front of the blank that ends
 * the header, and count as the end of line that they end with. False, with an error of the
 * current line of `from`, if the file cannot be read or is anything else; there is nothing to
 * close then. `name` is what the error calls it. */
bool etch_ppm_open(struct etch_ppm *ppm, const char *path, const char *name,
                   struct etch_text *from);

/* Gives the memory back. */
void etch_ppm_close(struct etch_ppm *ppm);

#endif
