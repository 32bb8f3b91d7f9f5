/* draw/row_index2.c: palettes, 2 bits a texel. Called for each row of an image. See
 * image.h. */
#include "image_row.h"

ETCH_ROW_COPY(etch_row_index2, etch_texel_index2)
