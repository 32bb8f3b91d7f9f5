/* raster/polygon_pixels.c: contours whose vertices are pixels. Called by applications and draw/.
 * See polygon.h. */
#include "polygon.h"

static struct etch_point_q8 centre(struct etch_point p)
{
    const struct etch_point_q8 c = {(int32_t)p.x * 256 + 128, (int32_t)p.y * 256 + 128};

    return c;
}

enum etch_status etch_polygon_add_pixels(struct etch_polygon *p, const struct etch_point *v,
                                         uint16_t n)
{
    if (n >= 3)
        for (uint16_t i = 0; i < n; i++)
            (void)etch_polygon_add_edge(p, centre(v[i]), centre(v[i + 1 == n ? 0 : i + 1]));
    return p->status;
}
