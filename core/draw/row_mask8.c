/* draw/row_mask8.c: a colour by a mask of 8 bits. Called for each row of an image. See
 * image.h. */
#include "image_row.h"

ETCH_ROW_BLEND(etch_row_mask8, etch_texel_ink, etch_texel_mask, false)
