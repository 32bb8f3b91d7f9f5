/* draw/row_index8_key.c: palettes, 8 bits a texel, 0 left out. Called for each row of an image. See
 * image.h. */
#include "image_row.h"

ETCH_ROW_KEY(etch_row_index8_key, etch_texel_index8, etch_texel_byte)
