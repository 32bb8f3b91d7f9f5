/* fragment/weights.h: how much each vertex of a triangle counts at a pixel, in perspective.
 *
 * What is linear in space is at a pixel the sum of its values at the vertices times their weights,
 *      weight i = (e_i / w_i) / (e_0 / w_0 + e_1 / w_1 + e_2 / w_2),
 * e_i the area that the pixel's centre spans with the edge opposite to vertex i. Inside a triangle
 * no term is negative, so nothing cancels: each product and sum is kept to 28 bits of itself, and
 * a weight errs by less than 2^-25 for every triangle, every pixel of it and every w.
 */
#ifndef ETCH_FRAGMENT_WEIGHTS_H
#define ETCH_FRAGMENT_WEIGHTS_H

#include "../base/weights.h"

#define ETCH_WEIGHT_ONE (INT32_C(1) << 29)

/* The weights of the sorted vertices 1 and 2, 0 .. ETCH_WEIGHT_ONE; that of vertex 0 is the rest.
 */
struct etch_weight_pair {
    int32_t one, two;
};

/* At the centre of pixel (x, y). Beyond an edge the weight of the opposite vertex counts as 0. */
struct etch_weight_pair etch_weights_at(const struct etch_weights *w, int16_t x, int16_t y);

/* base + d1 one + d2 two: a value in any format from its differences to vertex 0, which are given
 * in eighths of the format's unit; |d| < 2^31, and the true sum must fit. Errs by less than 2 units
 * and what the weights err by. */
ETCH_INLINE int32_t etch_weights_apply(struct etch_weight_pair w, int32_t base, int32_t d1_q3,
                                       int32_t d2_q3)
{
    return base + (etch_mul_high(d1_q3, w.one) + etch_mul_high(d2_q3, w.two));
}

#endif
