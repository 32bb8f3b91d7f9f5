/* size/smooth_round.c: smooth discs, rings, arcs, rounded rectangles and frames. */
#include "size.h"

#include "../../../core/fragment/cover.h"
#include "../../../core/raster/smooth_shapes.h"

volatile int16_t size_at[6];

int main(void)
{
    static const struct etch_surface s = SIZE_SURFACE(NULL);
    static int16_t cover[321];
    const struct etch_cover_flat_paint paint = {{etch_cover_flat}, 0xFFFF, 255};
    const struct etch_point_q8 a = {size_at[0], size_at[1]}, b = {size_at[2], size_at[3]};
    const int32_t r = size_at[4], t = size_at[5];

    etch_smooth_disc(&s, a, r, &paint.paint, cover);
    etch_smooth_ring(&s, a, r, t, &paint.paint, cover);
    etch_smooth_arc(&s, a, r, t, (uint16_t)size_at[2], (uint16_t)size_at[3], &paint.paint, cover);
    etch_smooth_round_rect(&s, a, b, r, &paint.paint, cover);
    etch_smooth_round_frame(&s, a, b, r, t, &paint.paint, cover);
    return 0;
}
