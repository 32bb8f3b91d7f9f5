/* draw/row_index4.c: palettes, 4 bits a texel. Called for each row of an image. See
 * image.h. */
#include "image_row.h"

ETCH_ROW_COPY(etch_row_index4, etch_texel_index4)
