/* fragment/texels_rgb565.c: texels that are colours. Called by filters, through the image. See
 * sampler.h. */
#include "sampler.h"

void etch_texels_rgb565(uint16_t *color, const uint16_t *column, const uint16_t *row, uint16_t n,
                        const struct etch_image *image)
{
    const uint16_t *const texels = (const uint16_t *)image->texels;
    const uint16_t stride = image->stride;

    for (uint16_t i = 0; i < n; i++)
        color[i] = texels[etch_mul_u16(row[i], stride) + column[i]];
}
