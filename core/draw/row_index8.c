/* draw/row_index8.c: palettes, 8 bits a texel. Called for each row of an image. See
 * image.h. */
#include "image_row.h"

ETCH_ROW_COPY(etch_row_index8, etch_texel_index8)
