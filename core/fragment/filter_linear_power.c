/* fragment/filter_linear_power.c: RGB565 textures, linear and repeated, fused. Called by the
 * texture stages, through the sampler. See sampler.h. */
#include "texel.h"

ETCH_FILTER_LINEAR(etch_filter_linear_power, etch_address_repeat_power, etch_texel_rgb565, NULL)
