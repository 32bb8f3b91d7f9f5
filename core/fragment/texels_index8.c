/* fragment/texels_index8.c: places in a palette of 256. Called by filters, through the image. See
 * sampler.h. */
#include "texel.h"

ETCH_TEXEL_FORMAT(etch_texels_index8, uint16_t, etch_texel_index8)
