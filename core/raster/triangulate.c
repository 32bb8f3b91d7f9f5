/* raster/triangulate.c: polygons without holes to triangles. Called by applications. See
 * triangulate.h. */
#include "triangulate_ring.h"

enum etch_status etch_triangulate(const struct etch_point_q8 *v, uint16_t n,
                                  struct etch_ring_node *node, etch_triangulate_function *triangle,
                                  void *context)
{
    struct etch_ring ring = {v, node};

    if (n < 3)
        return ETCH_OK;
    n = etch_ring_close(&ring, 0, 0, n, true);
    return n < 3 ? ETCH_OK : etch_ring_cut(&ring, 0, n, triangle, context);
}
