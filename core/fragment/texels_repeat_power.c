/* fragment/texels_repeat_power.c: repeats textures whose side is a power of two. Called by filters,
 * through the sampler. See sampler.h. */
#include "texel_place.h"

void etch_texels_repeat_power(uint16_t *texel, const int32_t *c_q16, uint16_t n, int16_t shift_q15,
                              uint16_t size)
{
    const uint32_t mask = (uint32_t)size - 1;

    ETCH_ASSERT((size & mask) == 0);
    for (uint16_t i = 0; i < n; i++)
        texel[i] = (uint16_t)((uint32_t)etch_texel_floor(c_q16[i], shift_q15) & mask);
}
