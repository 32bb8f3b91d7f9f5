/* fragment/texels_index4.c: places in a palette of 16. Called by filters, through the image. See
 * sampler.h. */
#include "texel.h"

ETCH_TEXEL_FORMAT(etch_texels_index4, uint16_t, etch_texel_index4)
