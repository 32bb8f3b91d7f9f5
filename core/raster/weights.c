/* raster/weights.c: what the weights of the vertices follow from. Called by draw/ for triangles
 * whose colours are in perspective. See weights.h. */
#include "weights.h"
#include "../base/texture.h"

/* The edge from vertex a to vertex b, its inside turned to the third. */
static void set_edge(struct etch_weight_edge *e, const struct etch_triangle *t, uint8_t a,
                     uint8_t b)
{
    e->x = t->p[a].x;
    e->y = t->p[a].y;
    e->dx = t->side * (t->p[b].x - t->p[a].x);
    e->dy = t->side * (t->p[b].y - t->p[a].y);
}

void etch_weights_setup(struct etch_weights *weights, const struct etch_triangle *t,
                        const uint32_t w[3])
{
    /* p[1] is right of the edge p[0] p[2] if side is +1: p[0], p[1], p[2] run clockwise */
    set_edge(&weights->edge[0], t, 2, 0);
    set_edge(&weights->edge[1], t, 0, 1);
    weights->area = (int64_t)t->area;
    for (uint8_t i = 0; i < 3; i++) {
        const uint32_t distance = w[t->order[i]] != 0 ? w[t->order[i]] : 1;
        const uint8_t zeros = etch_leading_zeros(distance);

        weights->inverse[i] = etch_reciprocal_q62(distance << zeros);
        weights->up[i] = zeros;
        weights->order[i] = t->order[i];
    }
}
