/* draw/row_rgb565_alpha_swapped.c: colours by a plane of alpha, byte-swapped. Called for each row
 * of an image. See image.h. */
#include "image_row.h"

ETCH_ROW_BLEND(etch_row_rgb565_alpha_swapped, etch_texel_rgb565, etch_texel_mask, true)
