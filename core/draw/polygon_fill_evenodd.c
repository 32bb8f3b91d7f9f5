/* draw/polygon_fill_evenodd.c: polygons in one colour by the even-odd rule. Called by applications.
 * See polygon.h. */
#include "polygon_contours.h"

enum etch_status etch_polygon_fill_evenodd(const struct etch_surface *s, const struct etch_point *v,
                                           const uint16_t *size, uint16_t contours, uint16_t color,
                                           struct etch_polygon_edge *edge, uint16_t room)
{
    const struct etch_flat_paint paint = {{etch_kernel_flat}, color};
    struct etch_polygon p;
    const enum etch_status status = polygon_contours(&p, v, size, contours, edge, room);

    etch_polygon_runs_evenodd(s, &p, &paint.paint);
    return status;
}
