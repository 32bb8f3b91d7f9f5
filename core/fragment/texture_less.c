/* fragment/texture_less.c: affine texture where nearer than the depth plane. See texture.h. */
#include "texture_row.h"

void etch_kernel_texture_less(const struct etch_surface *surface, int16_t y0,
                              const struct etch_run *runs, uint8_t n,
                              const struct etch_paint *paint)
{
    etch_depth_rows_less(surface, y0, runs, n, paint, etch_texel_span);
}
