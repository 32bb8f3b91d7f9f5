/* fragment/texels_unlike.c: all but a key colour. Called by filters, through the image. See
 * sampler.h. */
#include "texel.h"

ETCH_TEXEL_FORMAT(etch_texels_unlike, uint8_t, etch_texel_unlike)
