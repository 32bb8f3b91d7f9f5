/* raster/map_runs.c: mapped images to runs. Called by applications. See map_runs.h. */
#include "map_runs.h"

void etch_map_runs(const struct etch_surface *s, const struct etch_map *map,
                   const struct etch_paint *paint)
{
    const struct etch_rect area = etch_rect_intersect(s->clip, map->bounds);
    struct etch_run runs[ETCH_RUN_BLOCK];

    if (etch_rect_is_empty(area))
        return;
    for (int16_t y = area.y0; y < area.y1;) {
        const int16_t left = (int16_t)(area.y1 - y);
        const uint8_t n = (uint8_t)(left < ETCH_RUN_BLOCK ? left : ETCH_RUN_BLOCK);

        for (uint8_t i = 0; i < n; i++) {
            runs[i].x0 = area.x0, runs[i].x1 = area.x1;
            etch_map_interval(map, (int16_t)(y + i), &runs[i].x0, &runs[i].x1);
        }
        paint->kernel(s, y, runs, n, paint);
        y = (int16_t)(y + n);
    }
}
