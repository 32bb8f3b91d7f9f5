/* draw/row_index2_key.c: palettes, 2 bits a texel, 0 left out. Called for each row of an image. See
 * image.h. */
#include "image_row.h"

ETCH_ROW_KEY(etch_row_index2_key, etch_texel_index2, etch_texel_pair)
