/* tests/images/check.h: what the script writes down of each image, for check.c. */
#ifndef TESTS_IMAGES_CHECK_H
#define TESTS_IMAGES_CHECK_H

#include "core/draw/image_rle.h"

struct image_case {
    const char *label, *picture, *alpha; /* PPM files; alpha: or "" */
    const struct etch_image *plain;
    const struct etch_rle_image *packed;
    etch_image_row *row;
    const char *report; /* what etch-image said */
    const char *key;    /* RRGGBB that is left out, or "" */
    bool swapped;
};

extern const struct image_case image_cases[]; /* ends with a label of NULL */

#endif
