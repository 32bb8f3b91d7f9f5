/* fragment/texels_mirror.c: repeats textures of any size, every second one mirrored. Called by
 * filters, through the sampler. See sampler.h. */
#include "texel_place.h"

void etch_texels_mirror(uint16_t *texel, const int32_t *c_q16, uint16_t n, int16_t shift_q15,
                        uint16_t size)
{
    const int32_t period = (int32_t)size * 2;
    int32_t first = 0; /* of the period, a multiple of it */

    for (uint16_t i = 0; i < n; i++) {
        const int32_t k = etch_texel_floor(c_q16[i], shift_q15);

        if (k < first || k - first >= period)
            first = etch_texel_period(k, period);
        texel[i] = (uint16_t)(k - first < size ? k - first : period - 1 - (k - first));
    }
}
