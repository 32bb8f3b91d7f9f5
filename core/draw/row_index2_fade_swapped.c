/* draw/row_index2_fade_swapped.c: palettes, 2 bits a texel, by opacity, byte-swapped. Called for
 * each row of an image. See image.h. */
#include "image_row.h"

ETCH_ROW_BLEND(etch_row_index2_fade_swapped, etch_texel_index2, etch_texel_opaque, true)
