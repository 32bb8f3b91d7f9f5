/* draw/row_index1_key.c: palettes, 1 bit a texel, 0 left out. Called for each row of an image. See
 * image.h. */
#include "image_row.h"

ETCH_ROW_KEY(etch_row_index1_key, etch_texel_index1, etch_texel_bit)
