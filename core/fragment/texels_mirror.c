/* fragment/texels_mirror.c: every second period mirrored, any size. Called by filters, through the
 * sampler. See sampler.h. */
#include "texel.h"

ETCH_TEXEL_WRAP(etch_texels_mirror, etch_address_mirror)
