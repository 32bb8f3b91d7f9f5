/* fragment/texels_alpha8.c: alpha by a palette of 256. Called by filters, through the image. See
 * sampler.h. */
#include "texel.h"

ETCH_TEXEL_FORMAT(etch_texels_alpha8, uint8_t, etch_texel_alpha8)
