/* draw/row_index8_fade_swapped.c: palettes, 8 bits a texel, by opacity, byte-swapped. Called for
 * each row of an image. See image.h. */
#include "image_row.h"

ETCH_ROW_BLEND(etch_row_index8_fade_swapped, etch_texel_index8, etch_texel_opaque, true)
