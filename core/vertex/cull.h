/* vertex/cull.h: winding of the snapped triangle, and face culling.
 *
 * Winding is that of the vertices in 1/256 px, as seen on the screen: what is culled and what
 * is drawn never disagree.
 */
#ifndef ETCH_VERTEX_CULL_H
#define ETCH_VERTEX_CULL_H

#include "../base/sink.h"

/* Which triangles are dropped. Zero area is dropped by each of them. */
enum etch_cull {
    ETCH_CULL_NONE = 0,
    ETCH_CULL_CLOCKWISE = 1,        /* back faces, where front is counter-clockwise (default) */
    ETCH_CULL_COUNTER_CLOCKWISE = 2 /* front faces */
};

/* Twice the signed area, as a sign: +1 clockwise as seen, -1 counter-clockwise, 0 no area.
 * Exact for every vertex in range; 32-bit products where the triangle is under 32,768 / 256 px
 * wide and high. */
int8_t etch_winding(const struct etch_vertex *const v[3]);

/* True if the triangle is to be drawn. */
ETCH_INLINE bool etch_cull_keeps(enum etch_cull cull, const struct etch_vertex *const v[3])
{
    const int8_t winding = etch_winding(v);

    return winding != 0 && !(cull == ETCH_CULL_CLOCKWISE && winding > 0) &&
           !(cull == ETCH_CULL_COUNTER_CLOCKWISE && winding < 0);
}

#endif
