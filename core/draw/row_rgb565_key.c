/* draw/row_rgb565_key.c: colours but one. Called for each row of an image. See
 * image.h. */
#include "image_row.h"

ETCH_ROW_KEY(etch_row_rgb565_key, etch_texel_rgb565, etch_texel_unlike)
