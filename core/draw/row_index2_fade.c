/* draw/row_index2_fade.c: palettes, 2 bits a texel, by opacity. Called for each row of an image.
 * See image.h. */
#include "image_row.h"

ETCH_ROW_BLEND(etch_row_index2_fade, etch_texel_index2, etch_texel_opaque, false)
