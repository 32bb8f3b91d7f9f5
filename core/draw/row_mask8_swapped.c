/* draw/row_mask8_swapped.c: a colour by a mask of 8 bits, byte-swapped. Called for each row of an
 * image. See image.h. */
#include "image_row.h"

ETCH_ROW_BLEND(etch_row_mask8_swapped, etch_texel_ink, etch_texel_mask, true)
