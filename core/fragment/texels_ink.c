/* fragment/texels_ink.c: one colour, for masks. Called by filters, through the image. See
 * sampler.h. */
#include "texel.h"

ETCH_TEXEL_FORMAT(etch_texels_ink, uint16_t, etch_texel_ink)
