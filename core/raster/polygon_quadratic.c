/* raster/polygon_quadratic.c: quadratic curves in the contours of polygons. Called by applications.
 * See curve.h. */
#include "curve.h"

struct contour {
    struct etch_polygon *polygon;
    struct etch_point_q8 from;
};

static void add(void *context, struct etch_point_q8 to)
{
    struct contour *const c = context;

    (void)etch_polygon_add_edge(c->polygon, c->from, to);
    c->from = to;
}

enum etch_status etch_polygon_add_quadratic(struct etch_polygon *polygon,
                                            const struct etch_point_q8 p[3], int32_t flatness_q8)
{
    struct contour contour = {polygon, p[0]};

    if (polygon->status == ETCH_OK)
        etch_quadratic_flatten(p, flatness_q8, add, &contour);
    return polygon->status;
}
