/* fragment/texels_mask.c: a plane of alpha. Called by filters, through the image. See sampler.h. */
#include "sampler.h"

void etch_texels_mask(uint8_t *alpha, const uint16_t *column, const uint16_t *row, uint16_t n,
                      const struct etch_image *image)
{
    const uint8_t *const mask = image->alpha;
    const uint16_t stride = image->stride;

    for (uint16_t i = 0; i < n; i++)
        alpha[i] = mask[etch_mul_u16(row[i], stride) + column[i]];
}
