/* base/map_bounds.c: the rectangle that a map draws in. Called by the makers of maps. See
 * map_parts.h. */
#include "map_parts.h"

void etch_map_nothing(struct etch_map *map)
{
    *map = (struct etch_map){0, 0, 0, 0, 0, 0, {0, 0, 0, 0}, {0, 0, 0, 0}};
}

static int16_t hold(int64_t v)
{
    return (int16_t)(v > INT16_MAX ? INT16_MAX : v < INT16_MIN ? INT16_MIN : v);
}

/* Least and greatest of a u + b v over the corners; |a u| < 2^31 2^15. */
static void range(int64_t out[2], etch_q16 a, etch_q16 b, struct etch_rect from)
{
    const int64_t u[2] = {(int64_t)a * from.x0, (int64_t)a * from.x1};
    const int64_t v[2] = {(int64_t)b * from.y0, (int64_t)b * from.y1};

    out[0] = (u[0] < u[1] ? u[0] : u[1]) + (v[0] < v[1] ? v[0] : v[1]);
    out[1] = (u[0] < u[1] ? u[1] : u[0]) + (v[0] < v[1] ? v[1] : v[0]);
}

struct etch_rect etch_map_bounds(struct etch_rect from, const struct etch_affine *a, int64_t x,
                                 int64_t y)
{
    int64_t across[2], down[2];

    range(across, a->xu, a->xv, from);
    range(down, a->yu, a->yv, from);
    return (struct etch_rect){hold(((across[0] + x) >> 16) - 2), hold(((down[0] + y) >> 16) - 2),
                              hold(((across[1] + x) >> 16) + 3), hold(((down[1] + y) >> 16) + 3)};
}
