/* raster/triangulate_ring.h: rings of corners and their exact tests; no part of the API. */
#ifndef ETCH_RASTER_TRIANGULATE_RING_H
#define ETCH_RASTER_TRIANGULATE_RING_H

#include "triangulate.h"

struct etch_ring {
    const struct etch_point_q8 *v;
    struct etch_ring_node *node;
};

/* Twice the area of a, b, c: positive if clockwise as seen (y down). Below 2^50. */
ETCH_INLINE int64_t ring_turn(struct etch_point_q8 a, struct etch_point_q8 b,
                              struct etch_point_q8 c)
{
    return etch_mul_s32(b.x - a.x, c.y - a.y) - etch_mul_s32(b.y - a.y, c.x - a.x);
}

ETCH_INLINE bool ring_is_same(struct etch_point_q8 a, struct etch_point_q8 b)
{
    return a.x == b.x && a.y == b.y;
}

ETCH_INLINE struct etch_point_q8 ring_at(const struct etch_ring *ring, uint16_t node)
{
    return ring->v[ring->node[node].vertex];
}

/* Makes nodes from `first` on a ring of the n vertices from `vertex` on, clockwise as seen or not.
 * Vertices at the place of the one before are left out; returns how many are not. */
uint16_t etch_ring_close(struct etch_ring *ring, uint16_t first, uint16_t vertex, uint16_t n,
                         bool clockwise);

/* Cuts the ring of n nodes that `at` belongs to, clockwise, into triangles. */
enum etch_status etch_ring_cut(struct etch_ring *ring, uint16_t at, uint16_t n,
                               etch_triangulate_function *triangle, void *context);

#endif
