/* raster/smooth.c: takes the contours of a shape with covers. Called by applications and
 * smooth_shapes.h's functions. See smooth.h. */
#include "smooth.h"

void etch_smooth_init(struct etch_smooth *p, struct etch_smooth_edge *edge, uint16_t room)
{
    p->edge = edge;
    p->room = room;
    p->count = 0;
    p->line0 = INT32_MIN;
    p->line1 = INT32_MAX;
    p->status = ETCH_OK;
}

void etch_smooth_window(struct etch_smooth *p, const struct etch_surface *surface)
{
    p->line0 = 16 * (int32_t)surface->clip.y0;
    p->line1 = 16 * (int32_t)surface->clip.y1;
}

static bool is_in_range(int32_t v)
{
    return v >= -(INT32_C(1) << 23) && v <= INT32_C(1) << 23;
}

/* The first line at or below y: line k lies at 16 k + 8. */
static int32_t first_line(int32_t y)
{
    return (y + 7) >> 4;
}

enum etch_status etch_smooth_add_edge(struct etch_smooth *p, struct etch_point_q8 a,
                                      struct etch_point_q8 b)
{
    const bool up = b.y < a.y;
    const struct etch_point_q8 upper = up ? b : a, lower = up ? a : b;
    struct etch_smooth_edge *g;

    if (p->status != ETCH_OK)
        return p->status;
    if (!is_in_range(a.x) || !is_in_range(a.y) || !is_in_range(b.x) || !is_in_range(b.y))
        return p->status = ETCH_EINVAL;
    if (first_line(upper.y) == first_line(lower.y) || first_line(upper.y) >= p->line1 ||
        first_line(lower.y) <= p->line0)
        return ETCH_OK;
    if (p->count == p->room)
        return p->status = ETCH_ENOMEM;
    g = &p->edge[p->count++];
    g->next = NULL;
    g->a = upper;
    g->dx = lower.x - upper.x;
    g->dy = lower.y - upper.y;
    g->x = g->e = 0;
    g->line0 = first_line(upper.y);
    g->line1 = first_line(lower.y);
    g->winding = (int8_t)(up ? -1 : 1);
    return ETCH_OK;
}

enum etch_status etch_smooth_add(struct etch_smooth *p, const struct etch_point_q8 *v, uint16_t n)
{
    if (n >= 3)
        for (uint16_t i = 0; i < n; i++)
            (void)etch_smooth_add_edge(p, v[i], v[i + 1 == n ? 0 : i + 1]);
    return p->status;
}
