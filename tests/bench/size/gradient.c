/* size/gradient.c: rectangles filled by linear and radial gradients. */
#include "size.h"

#include "../../../core/fragment/gradient.h"
#include "../../../core/raster/rect.h"

volatile int16_t size_at[6];

int main(void)
{
    static const struct etch_surface s = SIZE_SURFACE(NULL);
    static const struct etch_stop stop[2] = {{0, 0, 0, 0}, {65535, 255, 255, 255}};
    const struct etch_rect r = etch_rect_from_size(size_at[0], size_at[1], size_at[2], size_at[3]);
    struct etch_gradient_linear linear;
    struct etch_gradient_radial radial;
    struct etch_brush_paint paint = {{etch_kernel_brush}, &linear.brush, 255};
    struct etch_ramp ramp;
    uint16_t color[64];

    if (etch_ramp_init(&ramp, color, 6, stop, 2) ||
        etch_gradient_linear_init(&linear, &ramp, size_at[0], size_at[1], size_at[2], size_at[3]) ||
        etch_gradient_radial_init(&radial, &ramp, size_at[0], size_at[1], size_at[2]))
        return 1;
    etch_rect_runs(&s, r, &paint.paint);
    paint.brush = &radial.brush;
    etch_rect_runs(&s, r, &paint.paint);
    return 0;
}
