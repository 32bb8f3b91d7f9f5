/* raster/triangulate_ring.c: cuts ears off a ring. Called by triangulate.c and
 * triangulate_holes.c. See triangulate.h.
 *
 * A corner b between a and c is an ear if it turns clockwise and no other corner lies in the closed
 * triangle a b c. Corners at the very place of a, b or c, which bridges make, do not count: an edge
 * from there into the triangle would have to end inside it or to cross its sides. */
#include "triangulate_ring.h"

static uint64_t add_wrap_u64(uint64_t a, uint64_t b)
{
    return a + b;
}

/* Twice the area by the fan round v[0]: modulo 2^64, and below 2^49 where the contour is simple. */
static bool is_clockwise(const struct etch_point_q8 *v, uint16_t n)
{
    uint64_t sum = 0;

    for (uint16_t i = 2; i < n; i++)
        sum = add_wrap_u64(sum, (uint64_t)ring_turn(v[0], v[i - 1], v[i]));
    return sum >> 63 == 0;
}

uint16_t etch_ring_close(struct etch_ring *ring, uint16_t first, uint16_t vertex, uint16_t n,
                         bool clockwise)
{
    const struct etch_point_q8 *const v = ring->v + vertex;
    const bool turned = is_clockwise(v, n) != clockwise;
    uint16_t kept = 0;

    for (uint16_t i = 0; i < n; i++) {
        const uint16_t at = (uint16_t)(turned ? n - 1 - i : i);
        struct etch_ring_node *const node = &ring->node[first + kept];

        if (ring_is_same(v[at], v[i != 0 ? (turned ? at + 1 : at - 1) : (turned ? 0 : n - 1)]))
            continue;
        node->vertex = (uint16_t)(vertex + at);
        node->next = (uint16_t)(first + kept + 1);
        node->previous = (uint16_t)(first + kept - 1);
        kept++;
    }
    if (kept != 0) {
        ring->node[first].previous = (uint16_t)(first + kept - 1);
        ring->node[first + kept - 1].next = first;
    }
    return kept;
}

/* Whether p, at none of the corners, lies in the closed triangle, which is clockwise. */
static bool is_in(struct etch_point_q8 p, struct etch_point_q8 a, struct etch_point_q8 b,
                  struct etch_point_q8 c)
{
    if (ring_is_same(p, a) || ring_is_same(p, b) || ring_is_same(p, c))
        return false;
    return ring_turn(a, b, p) >= 0 && ring_turn(b, c, p) >= 0 && ring_turn(c, a, p) >= 0;
}

static int64_t turn_at(const struct etch_ring *ring, uint16_t at)
{
    const struct etch_ring_node *const node = &ring->node[at];

    return ring_turn(ring_at(ring, node->previous), ring_at(ring, at), ring_at(ring, node->next));
}

static bool is_ear(const struct etch_ring *ring, uint16_t at)
{
    const struct etch_ring_node *const node = ring->node;
    const uint16_t before = node[at].previous, after = node[at].next;
    const struct etch_point_q8 a = ring_at(ring, before), b = ring_at(ring, at);
    const struct etch_point_q8 c = ring_at(ring, after);

    if (turn_at(ring, at) <= 0)
        return false;
    for (uint16_t i = node[after].next; i != before; i = node[i].next)
        if (is_in(ring_at(ring, i), a, b, c))
            return false;
    return true;
}

/* Takes the corner out; its neighbours may be ears now, or no more. */
static void cut(struct etch_ring *ring, uint16_t at)
{
    struct etch_ring_node *const node = ring->node;
    const uint16_t before = node[at].previous, after = node[at].next;

    node[before].next = after;
    node[after].previous = before;
    node[before].is_ear = is_ear(ring, before);
    node[after].is_ear = is_ear(ring, after);
}

/* A straight corner stays until it is part of an ear: without it the edge past it would go through
 * the end of a bridge that may be there. So it is in triangulations, and there is always an ear.
 * Where there is none the polygon has no area left or is not simple, and a corner without area goes
 * for nothing. */
enum etch_status etch_ring_cut(struct etch_ring *ring, uint16_t at, uint16_t n,
                               etch_triangulate_function *triangle, void *context)
{
    struct etch_ring_node *const node = ring->node;

    for (uint16_t i = 0; i < n; i++, at = node[at].next)
        node[at].is_ear = is_ear(ring, at);
    for (uint32_t looked = 0; n >= 3; at = node[at].next) {
        if (node[at].is_ear) {
            const uint16_t corner[3] = {node[node[at].previous].vertex, node[at].vertex,
                                        node[node[at].next].vertex};

            triangle(context, corner);
        } else if (looked < n || turn_at(ring, at) != 0) {
            if (++looked == 2 * (uint32_t)n)
                return ETCH_EINVAL;
            continue;
        }
        cut(ring, at);
        looked = 0;
        n--;
    }
    return ETCH_OK;
}
