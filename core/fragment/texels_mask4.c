/* fragment/texels_mask4.c: a plane of alpha, 4 bits a texel. Called by filters, through the image.
 * See sampler.h. */
#include "texel.h"

ETCH_TEXEL_FORMAT(etch_texels_mask4, uint8_t, etch_texel_mask4)
