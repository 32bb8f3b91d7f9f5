/* base/weights.h: a triangle's vertices and their distances, from which the weights of the vertices
 * at a pixel follow in perspective. raster/weights.c sets it up, fragment/weights.c reads it.
 */
#ifndef ETCH_BASE_WEIGHTS_H
#define ETCH_BASE_WEIGHTS_H

#include "fixed.h"

/* An edge by one of its ends and the way to the other, 1/256 px, turned so that
 *      e(X, Y) = dx (Y - y) - dy (X - x)
 * is positive inside: the area that the edge and (X, Y) span, twice, below 2^50. */
struct etch_weight_edge {
    int32_t x, y, dx, dy;
};

/* Of the sorted vertices 0, 1, 2 (order[i]: the caller's). 1/w is inverse 2^up, in any unit. */
struct etch_weights {
    struct etch_weight_edge edge[2]; /* opposite to vertices 1 and 2 */
    int64_t area;                    /* what the three e sum to, 1 .. 2^48 */
    int32_t inverse[3];              /* 2^30 .. 2^31 - 1 */
    uint8_t up[3];                   /* 0 .. 31 */
    uint8_t order[3];
};

#endif
