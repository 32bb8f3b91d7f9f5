/* base/map_invert.c: an image under any affine map. Called by applications. See map.h. */
#include "map_parts.h"

#define MOST_ENTRY (INT32_C(1) << 30)
#define MOST_STEP (INT32_C(8191) * 65536)

static bool within(etch_q16 v, int32_t most)
{
    return v >= -most && v <= most;
}

/* round(n / determinant) in 16.16, saturated: n 2^32 <= 2^62. */
static etch_q16 over(etch_q16 n, int64_t determinant)
{
    return etch_divide_round_s64((int64_t)n * (INT64_C(1) << 32), determinant);
}

enum etch_status etch_map_invert(struct etch_map *map, struct etch_rect from,
                                 const struct etch_affine *a)
{
    etch_map_nothing(map);
    if (!within(a->xu, MOST_ENTRY) || !within(a->xv, MOST_ENTRY) || !within(a->yu, MOST_ENTRY) ||
        !within(a->yv, MOST_ENTRY) || etch_rect_is_empty(from))
        return ETCH_EINVAL;
    const int64_t determinant = etch_mul_s32(a->xu, a->yv) - etch_mul_s32(a->xv, a->yu);

    if (determinant == 0)
        return ETCH_EINVAL;
    const etch_q16 ux = over(a->yv, determinant), uy = over(-a->xv, determinant);
    const etch_q16 vx = over(-a->yu, determinant), vy = over(a->xu, determinant);

    if (!within(ux, MOST_STEP) || !within(uy, MOST_STEP) || !within(vx, MOST_STEP) ||
        !within(vy, MOST_STEP))
        return ETCH_EINVAL;
    map->ux = (int64_t)ux * 65536, map->uy = (int64_t)uy * 65536;
    map->vx = (int64_t)vx * 65536, map->vy = (int64_t)vy * 65536;
    map->u = -etch_map_along(map->ux, a->x0) - etch_map_along(map->uy, a->y0);
    map->v = -etch_map_along(map->vx, a->x0) - etch_map_along(map->vy, a->y0);
    map->from = from;
    map->bounds = etch_map_bounds(from, a, a->x0, a->y0);
    return ETCH_OK;
}
