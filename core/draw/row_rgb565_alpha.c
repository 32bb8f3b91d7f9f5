/* draw/row_rgb565_alpha.c: colours by a plane of alpha. Called for each row of an image. See
 * image.h. */
#include "image_row.h"

ETCH_ROW_BLEND(etch_row_rgb565_alpha, etch_texel_rgb565, etch_texel_mask, false)
