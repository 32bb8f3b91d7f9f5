/* raster/polygon_sort.c: edges by their first rows. Called by polygon_walk.c.
 * Source: J. W. J. Williams, "Heapsort", 1964. */
#include "polygon_walk.h"

/* Puts g into the heap of n edges whose place `at` is free, its children being heaps. */
static void sift(struct etch_polygon_edge *edge, uint16_t n, uint16_t at,
                 const struct etch_polygon_edge *g)
{
    uint32_t child;

    while (child = 2 * (uint32_t)at + 1, child < n) {
        if (child + 1 < n && edge[child + 1].y0 > edge[child].y0)
            child++;
        if (edge[child].y0 <= g->y0)
            break;
        edge[at] = edge[child];
        at = (uint16_t)child;
    }
    edge[at] = *g;
}

void etch_polygon_sort(struct etch_polygon *p)
{
    struct etch_polygon_edge *const edge = p->edge;

    for (uint16_t i = p->count / 2; i != 0; i--) {
        const struct etch_polygon_edge g = edge[i - 1];

        sift(edge, p->count, (uint16_t)(i - 1), &g);
    }
    for (uint16_t n = p->count; n > 1; n--) {
        const struct etch_polygon_edge g = edge[n - 1];

        edge[n - 1] = edge[0];
        sift(edge, (uint16_t)(n - 1), 0, &g);
    }
    p->sorted = true;
}
