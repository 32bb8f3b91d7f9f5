/* raster/smooth_polygon.c: smooth polygons in one call. Called by applications. See
 * smooth_shapes.h. */
#include "smooth_shapes.h"

enum etch_status etch_smooth_polygon(const struct etch_surface *s, const struct etch_point_q8 *v,
                                     uint16_t n, struct etch_smooth_edge *edge, uint16_t room,
                                     const struct etch_cover_paint *paint, int16_t *cover)
{
    struct etch_smooth p;

    etch_smooth_init(&p, edge, room);
    etch_smooth_window(&p, s);
    (void)etch_smooth_add(&p, v, n);
    etch_smooth_fill_nonzero(s, &p, paint, cover);
    return p.status;
}
