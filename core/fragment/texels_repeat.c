/* fragment/texels_repeat.c: repeats textures of any size. Called by filters, through the sampler.
 * See sampler.h. */
#include "texel.h"

ETCH_TEXEL_WRAP(etch_texels_repeat, etch_address_repeat)
