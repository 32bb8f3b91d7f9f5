/* draw/row_rgb565.c: colours as they are. Called for each row of an image. See
 * image.h. */
#include "../base/copy.h"
#include "image_row.h"

ETCH_INLINE void copy_pixel(uint16_t *to, const struct etch_image *image, uint32_t place,
                            uint32_t opacity)
{
    (void)opacity;
    *to = etch_texel_rgb565(image, place);
}

void etch_row_rgb565(uint16_t *to, uint16_t n, const struct etch_image_line *line)
{
    const uint16_t *const texels = line->image->texels;

    if (line->step_q32 == UINT64_C(1) << 32 && line->down_step == 0)
        etch_copy_row(to, texels + (size_t)(line->place_q32 >> 32), n);
    else
        etch_image_row_sloped(to, n, line, copy_pixel);
}
