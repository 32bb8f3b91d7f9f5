/* raster/edge_run.c: a whole edge at once. Called by triangle.c for triangles inside the clip. See
 * edge.h. */
#include "edge.h"

int16_t *etch_edge_run(struct etch_point_q8 a, struct etch_point_q8 b, int16_t *out, int32_t n)
{
    struct edge g;

    edge_start(&g, a, b, false);
    return edge_walk(&g, out, n);
}
