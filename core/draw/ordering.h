/* draw/ordering.h: hidden surfaces by an ordering table: triangles drawn from far to near, without
 * a depth plane.
 *
 *  once a frame:      triangles -> &ordering.sink -> the caller's buffer, a bucket for each depth
 *  for every strip:   etch_ordering_draw -> a sink that rasterises
 *
 * A triangle has one place in the order, by the mean of its three depths. That is right for small
 * triangles that are apart in depth. It is wrong where a large one reaches over others, and cannot
 * be right where triangles pierce each other or overlap in a ring: draw/painter.h cuts those.
 * Source: the ordering tables of the Sony PlayStation, 1994; a bucket sort.
 */
#ifndef ETCH_DRAW_ORDERING_H
#define ETCH_DRAW_ORDERING_H

#include "../base/sink.h"

/* A triangle in its bucket, 52 bytes. */
struct etch_ordered {
    struct etch_vertex v[3];
    uint16_t next; /* in a ring, from the last of the bucket to the first */
};

struct etch_ordering {
    struct etch_sink sink; /* give &ordering.sink to what emits triangles */
    struct etch_ordered *triangle;
    uint16_t *bucket; /* the last triangle of each, or ETCH_ORDERING_NONE; 0 is nearest */
    uint16_t buckets, room;
    uint16_t count; /* of triangles kept */
    uint16_t lost;  /* of those that found no room, up to 65535 */
};

#define ETCH_ORDERING_NONE UINT16_MAX

/* Empties *o over the caller's buffers: `room` triangles (65534 at most) and `buckets` of 2 bytes,
 * 1 at least, each for 65536 / buckets of depth. */
void etch_ordering_init(struct etch_ordering *o, struct etch_ordered *triangle, uint16_t room,
                        uint16_t *bucket, uint16_t buckets);

/* Hands what is kept to to->triangle, from far to near, within a bucket in the order in which it
 * came. As often as wanted. */
void etch_ordering_draw(const struct etch_ordering *o, struct etch_sink *to);

#endif
