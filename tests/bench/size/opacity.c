/* size/opacity.c: rectangles in one colour with an opacity. */
#include "size.h"

#include "../../../core/fragment/blend_fused.h"
#include "../../../core/raster/rect.h"

volatile int16_t size_at[6];

int main(void)
{
    static const struct etch_surface s = SIZE_SURFACE(NULL);
    struct etch_flat_blend_paint paint;

    etch_flat_blend_init(&paint, etch_kernel_flat_blend, 0xFFFF, (uint8_t)size_at[4]);
    etch_rect_runs(&s, etch_rect_from_size(size_at[0], size_at[1], size_at[2], size_at[3]),
                   &paint.paint);
    return 0;
}
