/* base/map.c: the part of a row that shows an image. Called once a row by what draws images and
 * makes runs of them. See map.h. */
#include "map.h"

/* The first k >= 0 with c + k d >= 0, at most `most`; d > 0. */
static int32_t first(int64_t c, int64_t d, int32_t most)
{
    if (c >= 0)
        return 0;
    if (c + d * most < 0)
        return most;
    return (int32_t)etch_divide_u64((uint64_t)(d - 1 - c), (uint64_t)d).quotient;
}

/* Keeps of pixels 0 .. *n - 1, from *k on, those where 0 <= c + k d < limit. */
static void keep(int32_t *k, int32_t *n, int64_t c, int64_t d, int64_t limit)
{
    if (d == 0) {
        if (c < 0 || c >= limit)
            *n = *k;
        return;
    }
    if (d < 0) { /* from the other side: c + k d < limit from `begin` on, >= 0 up to before `end` */
        c = limit - 1 - c;
        d = -d;
    }
    const int32_t begin = first(c, d, *n), end = first(c - limit, d, *n);

    *k = begin > *k ? begin : *k;
    *n = end < *n ? end : *n;
}

void etch_map_interval(const struct etch_map *map, int16_t y, int16_t *x0, int16_t *x1)
{
    const int16_t left = *x0 > map->bounds.x0 ? *x0 : map->bounds.x0;
    const int16_t right = *x1 < map->bounds.x1 ? *x1 : map->bounds.x1;
    const int64_t one = INT64_C(1) << 32;
    int32_t k = 0, n = (int32_t)right - left;

    if (n <= 0 || y < map->bounds.y0 || y >= map->bounds.y1) {
        *x1 = *x0;
        return;
    }
    keep(&k, &n, map->u + map->uy * y + map->ux * left - map->from.x0 * one, map->ux,
         (map->from.x1 - map->from.x0) * one);
    keep(&k, &n, map->v + map->vy * y + map->vx * left - map->from.y0 * one, map->vx,
         (map->from.y1 - map->from.y0) * one);
    *x0 = (int16_t)(left + k);
    *x1 = (int16_t)(left + (n > k ? n : k));
}
