/* draw/row_rgb565_fade.c: colours by opacity. Called for each row of an image. See
 * image.h. */
#include "image_row.h"

ETCH_ROW_BLEND(etch_row_rgb565_fade, etch_texel_rgb565, etch_texel_opaque, false)
