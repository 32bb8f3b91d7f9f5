/* fragment/texels_clamp.c: holds coordinates inside the texture. Called by filters, through the
 * sampler. See sampler.h. */
#include "texel.h"

ETCH_TEXEL_WRAP(etch_texels_clamp, etch_address_clamp)
