/* fragment/texels_index2.c: a palette of 4. Called by filters, through the image. See sampler.h. */
#include "texel.h"

ETCH_TEXEL_FORMAT(etch_texels_index2, uint16_t, etch_texel_index2)
