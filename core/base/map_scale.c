/* base/map_scale.c: an image stretched over a rectangle. Called by applications and nine-patches.
 * See map.h. */
#include "map_parts.h"

/* ceil(n 2^32 / d) for n, d = 1 .. 65534. Nearest: with step and start rounded up, pixel i errs by
 * less than (i + 1) 2^-32 <= 2^-17 to the right; its exact place is a multiple of 1/(2 w) >=
 * 1/65534, so the whole part is exact. */
static int64_t ratio(int32_t n, int32_t d)
{
    const uint64_t up = (uint64_t)n << 32;

    return (int64_t)etch_divide_u64(up + (uint32_t)d - 1, (uint64_t)d).quotient;
}

/* One axis: texels from .. to - 1 over `size` pixels from `at` on. Returns the step, and where
 * pixel 0 is. */
static int64_t axis(int32_t from, int32_t to, int32_t at, int32_t size, int64_t *start)
{
    const int64_t step = ratio(to - from, size);

    *start = from * (INT64_C(1) << 32) + ratio(to - from, 2 * size) - step * at;
    return step;
}

void etch_map_scale(struct etch_map *map, struct etch_rect from, int16_t x, int16_t y, int16_t w,
                    int16_t h)
{
    if (w <= 0 || h <= 0 || from.x0 < 0 || from.y0 < 0 || etch_rect_is_empty(from)) {
        etch_map_nothing(map);
        return;
    }
    map->ux = axis(from.x0, from.x1, x, w, &map->u);
    map->vy = axis(from.y0, from.y1, y, h, &map->v);
    map->vx = map->uy = 0;
    map->from = from;
    map->bounds = etch_rect_from_size(x, y, w, h);
}
