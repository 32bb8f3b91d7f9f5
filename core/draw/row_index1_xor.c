/* draw/row_index1_xor.c: bits that take themselves away again. Called for each row of an image. See
 * image.h. */
#include "image_row.h"

ETCH_INLINE void xor_pixel(uint16_t *to, const struct etch_image *image, uint32_t place,
                           uint32_t opacity)
{
    (void)opacity;
    if (etch_texel_bit(image, place) != 0)
        *to = (uint16_t)(*to ^ image->palette[1]);
}

void etch_row_index1_xor(uint16_t *to, uint16_t n, const struct etch_image_line *line)
{
    etch_image_row_any(to, n, line, xor_pixel);
}
