/* fragment/texels_alpha4.c: alpha by a palette of 16. Called by filters, through the image. See
 * sampler.h. */
#include "texel.h"

ETCH_TEXEL_FORMAT(etch_texels_alpha4, uint8_t, etch_texel_alpha4)
