/* vertex/cull.c: winding of a snapped triangle. Called by assembly and draw/mesh, once a
 * triangle. See cull.h. */
#include "cull.h"

/* |v| or |v| - 1. */
static int32_t size(int32_t v)
{
    return v ^ (v >> 31);
}

int8_t etch_winding(const struct etch_vertex *const v[3])
{
    const int32_t ax = v[1]->x_q8 - v[0]->x_q8, ay = v[1]->y_q8 - v[0]->y_q8;
    const int32_t bx = v[2]->x_q8 - v[0]->x_q8, by = v[2]->y_q8 - v[0]->y_q8;

    if ((size(ax) | size(ay) | size(bx) | size(by)) < 32768) {
        /* each product at most 2^30: compare, since the difference may be 2^31 */
        const int32_t right = ax * by, left = ay * bx;

        return (int8_t)((right > left) - (right < left));
    }
    /* differences at most 2^24, products 2^48 */
    const int64_t right = etch_mul_s32(ax, by), left = etch_mul_s32(ay, bx);

    return (int8_t)((right > left) - (right < left));
}
