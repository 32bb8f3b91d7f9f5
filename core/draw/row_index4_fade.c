/* draw/row_index4_fade.c: palettes, 4 bits a texel, by opacity. Called for each row of an image.
 * See image.h. */
#include "image_row.h"

ETCH_ROW_BLEND(etch_row_index4_fade, etch_texel_index4, etch_texel_opaque, false)
