/* raster/polygon_walk.c: walks the edges of a polygon from row to row, sorted by x. Called by
 * polygon_evenodd.c and polygon_nonzero.c. See polygon.h.
 *
 * Edges that lie right of the clip are left out: what they begin or end is not seen. */
#include "polygon_edge.h"
#include "polygon_walk.h"

static void insert(struct etch_polygon_edge **list, struct etch_polygon_edge *g)
{
    while (*list != NULL && (*list)->x < g->x)
        list = &(*list)->next;
    g->next = *list;
    *list = g;
}

/* Takes out the edges that end above row y and brings the others there, in order. */
static void step(struct etch_polygon_edge **list, int16_t y)
{
    struct etch_polygon_edge **at = list;
    int32_t x = INT32_MIN; /* of the edge before *at */

    while (*at != NULL) {
        struct etch_polygon_edge *const g = *at;

        if (g->y1 == y) {
            *at = g->next;
            continue;
        }
        etch_polygon_edge_step(g);
        if (g->x < x) { /* it crossed edges to its left */
            *at = g->next;
            insert(list, g);
        } else {
            x = g->x;
            at = &g->next;
        }
    }
}

void etch_polygon_walk(const struct etch_surface *surface, struct etch_polygon *p,
                       const struct etch_paint *paint, etch_polygon_row *row)
{
    const struct etch_rect clip = surface->clip;
    struct etch_polygon_edge *active = NULL, *edge = p->edge;
    const struct etch_polygon_edge *end;
    struct etch_run_band band;
    int16_t y = clip.y0;

    if (p->status != ETCH_OK || p->count == 0 || etch_rect_is_empty(clip))
        return;
    end = edge + p->count;
    if (!p->sorted)
        etch_polygon_sort(p);
    etch_run_band_init(&band, surface, paint);
    while (y < clip.y1) {
        for (; edge != end && edge->y0 <= y; edge++) {
            if (edge->y1 > y && edge->left < clip.x1) {
                etch_polygon_edge_move(edge, y);
                insert(&active, edge);
            }
        }
        if (active != NULL) {
            row(&band, y, active);
            etch_run_band_row(&band, y);
            y++;
            step(&active, y);
        } else if (edge != end) {
            y = edge->y0;
        } else {
            break;
        }
    }
    etch_run_band_flush(&band);
}
