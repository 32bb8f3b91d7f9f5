/* fragment/texture_perspective_less.c: texture in perspective, a divide every 16 pixels, where
 * nearer than the depth plane. See texture.h. */
#include "texture_block.h"

void etch_kernel_perspective_less(const struct etch_surface *surface, int16_t y0,
                                  const struct etch_run *runs, uint8_t n,
                                  const struct etch_paint *paint)
{
    etch_depth_rows_less(surface, y0, runs, n, paint, etch_texel_blocks);
}
