/* fragment/flat_blend_init.c: one colour and an opacity for any shape. Called by applications. See
 * blend_fused.h. */
#include "blend_fused.h"

void etch_flat_blend_init(struct etch_flat_blend_paint *p, etch_kernel *kernel, uint16_t color,
                          uint8_t opacity)
{
    const uint32_t s = color, a = opacity;

    p->paint.kernel = kernel;
    p->red_blue = ((s >> 11) * a + 128) | ((s & 31) * a + 128) << 16;
    p->green = (uint16_t)((s >> 5 & 63) * a + 128);
    p->keep = (uint8_t)(255 - a);
}
