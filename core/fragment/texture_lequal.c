/* fragment/texture_lequal.c: affine texture where not farther than the depth plane. See texture.h.
 */
#include "texture_row.h"

void etch_kernel_texture_lequal(const struct etch_surface *surface, int16_t y0,
                                const struct etch_run *runs, uint8_t n,
                                const struct etch_paint *paint)
{
    etch_depth_rows_lequal(surface, y0, runs, n, paint, etch_texel_span);
}
