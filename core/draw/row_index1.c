/* draw/row_index1.c: palettes, 1 bit a texel. Called for each row of an image. See
 * image.h. */
#include "image_row.h"

ETCH_ROW_COPY(etch_row_index1, etch_texel_index1)
