/* draw/row_index1_fade_swapped.c: palettes, 1 bit a texel, by opacity, byte-swapped. Called for
 * each row of an image. See image.h. */
#include "image_row.h"

ETCH_ROW_BLEND(etch_row_index1_fade_swapped, etch_texel_index1, etch_texel_opaque, true)
