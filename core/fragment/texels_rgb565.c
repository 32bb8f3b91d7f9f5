/* fragment/texels_rgb565.c: texels that are colours. Called by filters, through the image. See
 * sampler.h. */
#include "texel.h"

ETCH_TEXEL_FORMAT(etch_texels_rgb565, uint16_t, etch_texel_rgb565)
