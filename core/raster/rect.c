/* raster/rect.c: rectangles to runs. Called by draw/. See rect.h. */
#include "rect.h"

void etch_rect_runs(const struct etch_surface *s, struct etch_rect rect,
                    const struct etch_paint *paint)
{
    const struct etch_rect r = etch_rect_intersect(rect, s->clip);
    struct etch_run runs[ETCH_RUN_BLOCK];

    if (etch_rect_is_empty(r))
        return;
    for (uint8_t i = 0; i < ETCH_RUN_BLOCK; i++)
        runs[i].x0 = r.x0, runs[i].x1 = r.x1;
    for (int16_t y = r.y0; y < r.y1;) {
        const int16_t n = (int16_t)(r.y1 - y < ETCH_RUN_BLOCK ? r.y1 - y : ETCH_RUN_BLOCK);

        paint->kernel(s, y, runs, (uint8_t)n, paint);
        y = (int16_t)(y + n);
    }
}
