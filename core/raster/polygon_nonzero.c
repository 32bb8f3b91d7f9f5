/* raster/polygon_nonzero.c: polygons by the non-zero rule. Called by applications and draw/. See
 * polygon.h. */
#include "polygon_walk.h"

static void row(struct etch_run_band *band, int16_t y, const struct etch_polygon_edge *edge)
{
    int32_t winding = 0, x0 = 0;

    for (; edge != NULL; edge = edge->next) {
        const int32_t before = winding;

        winding += edge->winding;
        if (before == 0)
            x0 = edge->x;
        else if (winding == 0)
            etch_run_band_add(band, y, x0, edge->x);
    }
    if (winding != 0) /* what ends it is right of the clip */
        etch_run_band_add(band, y, x0, band->surface->clip.x1);
}

void etch_polygon_runs_nonzero(const struct etch_surface *surface, struct etch_polygon *p,
                               const struct etch_paint *paint)
{
    etch_polygon_walk(surface, p, paint, row);
}
