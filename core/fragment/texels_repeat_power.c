/* fragment/texels_repeat_power.c: repeats sides that are powers of two. Called by filters, through
 * the sampler. See sampler.h. */
#include "texel.h"

ETCH_TEXEL_WRAP(etch_texels_repeat_power, etch_address_repeat_power)
