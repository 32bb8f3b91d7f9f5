/* draw/row_index4_key.c: palettes, 4 bits a texel, 0 left out. Called for each row of an image. See
 * image.h. */
#include "image_row.h"

ETCH_ROW_KEY(etch_row_index4_key, etch_texel_index4, etch_texel_nibble)
