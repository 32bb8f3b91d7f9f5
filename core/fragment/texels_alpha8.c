/* fragment/texels_alpha8.c: alpha by a palette of 256. Called by filters, through the image. See
 * sampler.h. */
#include "sampler.h"

void etch_texels_alpha8(uint8_t *alpha, const uint16_t *column, const uint16_t *row, uint16_t n,
                        const struct etch_image *image)
{
    const uint8_t *const texels = (const uint8_t *)image->texels;
    const uint8_t *const palette = image->alpha;
    const uint16_t stride = image->stride;

    for (uint16_t i = 0; i < n; i++)
        alpha[i] = palette[texels[etch_mul_u16(row[i], stride) + column[i]]];
}
