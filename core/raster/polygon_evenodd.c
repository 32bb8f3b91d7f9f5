/* raster/polygon_evenodd.c: polygons by the even-odd rule. Called by applications and draw/. See
 * polygon.h. */
#include "polygon_walk.h"

static void row(struct etch_run_band *band, int16_t y, const struct etch_polygon_edge *edge)
{
    for (; edge != NULL; edge = edge->next) {
        const int32_t x0 = edge->x;

        edge = edge->next;
        if (edge == NULL) { /* its partner is right of the clip */
            etch_run_band_add(band, y, x0, band->surface->clip.x1);
            return;
        }
        etch_run_band_add(band, y, x0, edge->x);
    }
}

void etch_polygon_runs_evenodd(const struct etch_surface *surface, struct etch_polygon *p,
                               const struct etch_paint *paint)
{
    etch_polygon_walk(surface, p, paint, row);
}
