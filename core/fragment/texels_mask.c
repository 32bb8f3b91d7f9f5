/* fragment/texels_mask.c: a plane of alpha. Called by filters, through the image. See
 * sampler.h. */
#include "texel.h"

ETCH_TEXEL_FORMAT(etch_texels_mask, uint8_t, etch_texel_mask)
