/* raster/triangulate_holes.c: polygons with holes to triangles. Called by applications. See
 * triangulate.h.
 *
 * The contours are rings of nodes, the holes wound against the outside. The hole with the rightmost
 * corner is joined first: from there some corner of the outside is always in sight, because no hole
 * that is left reaches further right. A bridge is walked on both sides, so it takes two nodes:
 *
 *      .. o -> h .. round the hole .. h' -> o' ..       h' at the place of h, o' at that of o
 */
#include "triangulate_ring.h"

/* `is_ear` of the first node of a contour: it is part of the outside. */
struct contours {
    struct etch_ring ring;
    const uint16_t *size;
    uint16_t count;
};

/* Whether p lies on the line a b, between its ends. */
static bool is_between(struct etch_point_q8 a, struct etch_point_q8 b, struct etch_point_q8 p)
{
    return ring_turn(a, b, p) == 0 && !ring_is_same(a, p) && !ring_is_same(b, p) &&
           (a.x < b.x ? p.x >= a.x && p.x <= b.x : p.x >= b.x && p.x <= a.x) &&
           (a.y < b.y ? p.y >= a.y && p.y <= b.y : p.y >= b.y && p.y <= a.y);
}

/* Whether lines p q and a b have a point in common that is not an end of both. */
static bool do_meet(struct etch_point_q8 p, struct etch_point_q8 q, struct etch_point_q8 a,
                    struct etch_point_q8 b)
{
    const int64_t ta = ring_turn(p, q, a), tb = ring_turn(p, q, b);
    const int64_t tp = ring_turn(a, b, p), tq = ring_turn(a, b, q);

    if (((ta < 0 && tb > 0) || (ta > 0 && tb < 0)) && ((tp < 0 && tq > 0) || (tp > 0 && tq < 0)))
        return true;
    return is_between(p, q, a) || is_between(p, q, b) || is_between(a, b, p) || is_between(a, b, q);
}

/* Whether an edge of the ring that `first` belongs to is in the way from p to q. */
static bool is_hidden(const struct etch_ring *ring, uint16_t first, struct etch_point_q8 p,
                      struct etch_point_q8 q)
{
    uint16_t i = first;

    do {
        const uint16_t next = ring->node[i].next;

        if (do_meet(p, q, ring_at(ring, i), ring_at(ring, next)))
            return true;
        i = next;
    } while (i != first);
    return false;
}

/* Whether p is seen from corner `at`, looking into the inside. */
static bool looks_at(const struct etch_ring *ring, uint16_t at, struct etch_point_q8 p)
{
    const struct etch_point_q8 a = ring_at(ring, ring->node[at].previous), b = ring_at(ring, at);
    const struct etch_point_q8 c = ring_at(ring, ring->node[at].next);
    const bool in = ring_turn(a, b, p) > 0, out = ring_turn(b, c, p) > 0;

    return ring_turn(a, b, c) > 0 ? in && out : in || out;
}

/* Whether nothing is in the way from corner `at` of the outside to corner `to` of a hole. */
static bool is_in_sight(const struct contours *c, uint16_t at, uint16_t to)
{
    const struct etch_ring *const ring = &c->ring;
    const struct etch_point_q8 p = ring_at(ring, at), q = ring_at(ring, to);

    if (!looks_at(ring, at, q) || is_hidden(ring, 0, p, q))
        return false;
    for (uint16_t i = 0, first = 0; i < c->count; first = (uint16_t)(first + c->size[i++]))
        if (c->size[i] != 0 && !ring->node[first].is_ear && is_hidden(ring, first, p, q))
            return false;
    return true;
}

/* The rightmost corner of the holes that are left; *hole is the first node of its contour. */
static uint16_t rightmost(const struct contours *c, uint16_t *hole)
{
    const struct etch_ring *const ring = &c->ring;
    uint16_t best = 0, first = c->size[0];
    bool found = false;

    for (uint16_t i = 1; i < c->count; first = (uint16_t)(first + c->size[i++])) {
        if (c->size[i] == 0 || ring->node[first].is_ear)
            continue;
        uint16_t at = first;

        do {
            if (!found || ring_at(ring, at).x > ring_at(ring, best).x) {
                found = true;
                best = at;
                *hole = first;
            }
            at = ring->node[at].next;
        } while (at != first);
    }
    return best;
}

/* Joins the hole of corner `to` to the outside at `at`, by nodes `spare` and the one after. */
static void join(struct etch_ring_node *node, uint16_t at, uint16_t to, uint16_t spare)
{
    const uint16_t far = (uint16_t)(spare + 1); /* spare: o', far: h' */

    node[spare].vertex = node[at].vertex;
    node[spare].next = node[at].next;
    node[spare].previous = far;
    node[far].vertex = node[to].vertex;
    node[far].next = spare;
    node[far].previous = node[to].previous;
    node[node[at].next].previous = spare;
    node[node[to].previous].next = far;
    node[at].next = to;
    node[to].previous = at;
}

/* Squared, below 2^51. */
static int64_t distance(struct etch_point_q8 a, struct etch_point_q8 b)
{
    return etch_mul_s32(a.x - b.x, a.x - b.x) + etch_mul_s32(a.y - b.y, a.y - b.y);
}

/* Joins the next hole to the nearest corner that is in sight; false if there is none. */
static bool bridge(struct contours *c, uint16_t spare)
{
    const struct etch_ring *const ring = &c->ring;
    uint16_t hole = 0, best = 0, at = 0;
    const uint16_t to = rightmost(c, &hole);
    int64_t least = INT64_MAX;

    do {
        const int64_t far = distance(ring_at(ring, at), ring_at(ring, to));

        if (far < least && is_in_sight(c, at, to)) {
            least = far;
            best = at;
        }
        at = ring->node[at].next;
    } while (at != 0);
    if (least == INT64_MAX)
        return false;
    join(ring->node, best, to, spare);
    ring->node[hole].is_ear = true;
    return true;
}

enum etch_status etch_triangulate_holes(const struct etch_point_q8 *v, const uint16_t *size,
                                        uint16_t contours, struct etch_ring_node *node,
                                        uint16_t room, etch_triangulate_function *triangle,
                                        void *context)
{
    struct contours c = {{v, node}, size, contours};
    uint32_t n = 0;
    uint16_t holes = 0, corners = 0;

    for (uint16_t i = 0; i < contours; i++)
        n += size[i];
    if (n + 2 * (uint32_t)contours > room || n + 2 * (uint32_t)contours > UINT16_MAX - 1)
        return ETCH_ENOMEM;
    n = 0;
    for (uint16_t i = 0; i < contours; n += size[i++]) {
        const uint16_t kept = etch_ring_close(&c.ring, (uint16_t)n, (uint16_t)n, size[i], i == 0);

        if (i == 0 && kept < 3)
            return ETCH_OK;
        if (size[i] != 0)
            node[n].is_ear = i == 0 || kept < 3;
        if (i != 0 && kept >= 3)
            holes++, corners = (uint16_t)(corners + 2);
        if (kept >= 3)
            corners = (uint16_t)(corners + kept);
    }
    for (; holes != 0; holes--, n += 2)
        if (!bridge(&c, (uint16_t)n))
            return ETCH_EINVAL;
    return etch_ring_cut(&c.ring, 0, corners, triangle, context);
}
