/* fragment/filter_nearest_power.c: RGB565 textures, nearest and repeated, fused. Called by the
 * texture stages, through the sampler. See sampler.h. */
#include "texel.h"

ETCH_FILTER_NEAREST(etch_filter_nearest_power, etch_address_repeat_power, etch_texel_rgb565, NULL)
