/* fragment/texels_clamp.c: holds coordinates inside the texture. Called by filters, through the
 * sampler. See sampler.h. */
#include "texel_place.h"

void etch_texels_clamp(uint16_t *texel, const int32_t *c_q16, uint16_t n, int16_t shift_q15,
                       uint16_t size)
{
    for (uint16_t i = 0; i < n; i++) {
        const int32_t k = etch_texel_floor(c_q16[i], shift_q15);

        texel[i] = (uint16_t)(k < 0 ? 0 : k >= size ? size - 1 : k);
    }
}
