/* draw/triangle_flat_blend.c: triangles in one colour and alpha. Called by applications and by the
 * mesh's sink. See blend.h. */
#include "../fragment/blend_fused.h"
#include "blend.h"
#include "setup.h"

/* What colour and half of rounding come to before the pixel is known: (s a + 255 / 2), s in steps
 * with `bits` fraction bits, and 1 for the division. */
static uint32_t part(uint32_t s, uint32_t a, uint8_t bits)
{
    return ((s * a + (UINT32_C(255) << (bits - 1))) >> bits) + 1;
}

void etch_triangle_flat_blend(const struct etch_surface *s, const struct etch_vertex *const v[3],
                              etch_kernel *kernel)
{
    const uint32_t a = v[0]->a;
    struct etch_flat_blend_paint paint;
    struct etch_triangle t;

    if (!setup_visible(&t, s, v))
        return;
    paint.paint.kernel = kernel;
    paint.red_blue = part((etch_channel_q27(v[0]->r) - (UINT32_C(1) << 26)) >> 16, a, 11) |
                     part((etch_channel_q27(v[0]->b) - (UINT32_C(1) << 26)) >> 16, a, 11) << 16;
    paint.green = (uint16_t)part((etch_channel_q26(v[0]->g) - (UINT32_C(1) << 25)) >> 16, a, 10);
    paint.keep = (uint8_t)(255 - a);
    etch_triangle_runs(s, &t, &paint.paint);
}
