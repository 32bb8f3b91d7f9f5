/* base/map_scale.c: an image stretched over a rectangle. Called by applications and nine-patches. See
 * map.h. */
#include "map_parts.h"

/* ceil(n 2^32 / d) for n, d = 1 .. 65534. Nearest: with step and start rounded up, pixel i errs by less
 * than (i + 1) 2^-32 <= 2^-17 to the right; its exact place is a multiple of 1/(2 w) >= 1/65534, so the
 * whole part is exact. */
static int64_t ratio(int32_t n, int32_t d)
{
    const uint64_t up = (uint64_t)n << 32;

    return (int64_t)etch_divide_u64(up + (uint32_t)d - 1, (uint64_t)d).quotient;
}

void etch_map_scale(struct etch_map *map, struct etch_rect from, int16_t x, int16_t y, int16_t w,
                    int16_t h)
{
    const int32_t columns = (int32_t)from.x1 - from.x0, rows = (int32_t)from.y1 - from.y0;

    if (w <= 0 || h <= 0 || from.x0 < 0 || from.y0 < 0 || etch_rect_is_empty(from)) {
        etch_map_nothing(map);
        return;
    }
    *map = (struct etch_map){
        .ux = ratio(columns, w),
        .vy = ratio(rows, h),
        .from = from,
        .bounds = etch_rect_from_size(x, y, w, h),
    };
    map->u = from.x0 * (INT64_C(1) << 32) + ratio(columns, 2 * (int32_t)w) - map->ux * x;
    map->v = from.y0 * (INT64_C(1) << 32) + ratio(rows, 2 * (int32_t)h) - map->vy * y;
}
