/* fragment/texels_mirror_power.c: the same, powers of two. Called by filters, through the sampler.
 * See sampler.h. */
#include "texel.h"

ETCH_TEXEL_WRAP(etch_texels_mirror_power, etch_address_mirror_power)
