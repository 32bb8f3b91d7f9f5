/* draw/row_index8_fade.c: palettes, 8 bits a texel, by opacity. Called for each row of an image.
 * See image.h. */
#include "image_row.h"

ETCH_ROW_BLEND(etch_row_index8_fade, etch_texel_index8, etch_texel_opaque, false)
