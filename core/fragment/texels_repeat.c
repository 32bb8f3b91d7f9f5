/* fragment/texels_repeat.c: repeats textures of any size. Called by filters, through the sampler. See
 * sampler.h. */
#include "texel_place.h"

/* Neighbours mostly lie in the same period: only a new one costs a division. */
void etch_texels_repeat(uint16_t *texel, const int32_t *c_q16, uint16_t n, int16_t shift_q15,
                        uint16_t size)
{
    int32_t first = 0; /* of the period, a multiple of the size */

    for (uint16_t i = 0; i < n; i++) {
        const int32_t k = etch_texel_floor(c_q16[i], shift_q15);

        if (k < first || k - first >= size)
            first = etch_texel_period(k, size);
        texel[i] = (uint16_t)(k - first);
    }
}
