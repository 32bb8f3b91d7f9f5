/* fragment/texels_index1.c: a palette of 2. Called by filters, through the image. See sampler.h. */
#include "texel.h"

ETCH_TEXEL_FORMAT(etch_texels_index1, uint16_t, etch_texel_index1)
