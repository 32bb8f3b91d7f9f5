/* size/smooth_line.c: smooth lines, square and round ends, and polygons. */
#include "size.h"

#include "../../../core/fragment/cover.h"
#include "../../../core/raster/smooth_shapes.h"

volatile int16_t size_at[6];

int main(void)
{
    static const struct etch_surface s = SIZE_SURFACE(NULL);
    static int16_t cover[321];
    static struct etch_smooth_edge edge[3];
    const struct etch_cover_flat_paint paint = {{etch_cover_flat}, 0xFFFF, 255};
    const struct etch_point_q8 v[3] = {
        {size_at[0], size_at[1]}, {size_at[2], size_at[3]}, {size_at[4], size_at[5]}};

    etch_smooth_line(&s, v[0], v[1], size_at[4], &paint.paint, cover);
    etch_smooth_line_round(&s, v[0], v[1], size_at[4], &paint.paint, cover);
    return etch_smooth_polygon(&s, v, 3, edge, 3, &paint.paint, cover);
}
