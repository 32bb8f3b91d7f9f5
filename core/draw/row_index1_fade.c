/* draw/row_index1_fade.c: palettes, 1 bit a texel, by opacity. Called for each row of an image. See
 * image.h. */
#include "image_row.h"

ETCH_ROW_BLEND(etch_row_index1_fade, etch_texel_index1, etch_texel_opaque, false)
