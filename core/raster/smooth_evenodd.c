/* raster/smooth_evenodd.c: covers by the even-odd rule. Called by applications. See smooth.h. */
#include "smooth_walk.h"

static void line(struct etch_smooth_row *row, const struct etch_smooth_edge *edge)
{
    int32_t winding = 0;

    for (; edge != NULL; edge = edge->next) {
        const int32_t after = 1 - winding;

        if (winding == 0 || after == 0)
            etch_smooth_mark(row, edge->x, winding == 0 ? 1 : -1);
        winding = after;
    }
}

void etch_smooth_fill_evenodd(const struct etch_surface *surface, struct etch_smooth *p,
                              const struct etch_cover_paint *paint, int16_t *cover)
{
    etch_smooth_walk(surface, p, paint, cover, line);
}
