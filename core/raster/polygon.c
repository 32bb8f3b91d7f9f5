/* raster/polygon.c: takes the contours of a polygon. Called by applications and draw/. See
 * polygon.h. */
#include "polygon_edge.h"

void etch_polygon_init(struct etch_polygon *p, struct etch_polygon_edge *edge, uint16_t room)
{
    p->edge = edge;
    p->room = room;
    p->count = 0;
    p->sorted = true;
    p->status = ETCH_OK;
}

static bool is_in_range(struct etch_point_q8 v)
{
    const int32_t limit = INT32_C(1) << 23;

    return v.x >= -limit && v.x <= limit && v.y >= -limit && v.y <= limit;
}

enum etch_status etch_polygon_add_edge(struct etch_polygon *p, struct etch_point_q8 a,
                                       struct etch_point_q8 b)
{
    struct etch_polygon_edge g;

    if (p->status != ETCH_OK)
        return p->status;
    if (!is_in_range(a) || !is_in_range(b))
        return p->status = ETCH_EINVAL;
    if (!etch_polygon_edge_setup(&g, a, b))
        return ETCH_OK;
    if (p->count == p->room)
        return p->status = ETCH_ENOMEM;
    p->edge[p->count++] = g;
    p->sorted = false;
    return ETCH_OK;
}

enum etch_status etch_polygon_add(struct etch_polygon *p, const struct etch_point_q8 *v, uint16_t n)
{
    if (n >= 3)
        for (uint16_t i = 0; i < n; i++)
            (void)etch_polygon_add_edge(p, v[i], v[i + 1 == n ? 0 : i + 1]);
    return p->status;
}
