/* fragment/filter_linear_clamp.c: opaque RGB565 held at its edges, the four nearest texels. Called
 * by the texture stages, through the sampler. See sampler.h. */
#include "texel.h"

ETCH_FILTER_LINEAR(etch_filter_linear_clamp, etch_address_clamp, etch_texel_rgb565, NULL)
