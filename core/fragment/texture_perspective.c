/* fragment/texture_perspective.c: texture in perspective, a divide every 16 pixels, without depth.
 * See texture.h. */
#include "texture_block.h"

void etch_kernel_perspective(const struct etch_surface *surface, int16_t y0,
                             const struct etch_run *runs, uint8_t n, const struct etch_paint *paint)
{
    for (; n != 0; n--, runs++, y0++)
        if (runs->x0 != runs->x1)
            etch_texel_blocks(surface->pixels + etch_surface_index(surface, runs->x0, y0), runs->x0,
                              (uint32_t)(runs->x1 - runs->x0), y0, paint);
}
