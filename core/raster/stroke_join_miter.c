/* raster/stroke_join_miter.c: joints with a point. Named in struct etch_stroke. See stroke.h.
 *
 * With h half the width and t the angle between `in` and `out`, the point lies at m = (in + out) /
 * (1 + cos t), |m| = h / cos(t / 2), and the miter is |m| / h widths long. in . out = h^2 cos t, so
 * it is within the limit L iff 1 / cos^2(t / 2) = 2 h^2 / (h^2 + in . out) <= L^2. */
#include "stroke_parts.h"

void etch_join_miter(const struct etch_outline *o, struct etch_point_q8 p, struct etch_point_q8 in,
                     struct etch_point_q8 out, const struct etch_stroke *stroke)
{
    const int64_t h = stroke->width_q8 / 2;
    const int64_t both = h * h + etch_mul_s32(in.x, out.x) + etch_mul_s32(in.y, out.y); /* < 2^30 */
    const int64_t limit = (int64_t)stroke->miter_q8 * stroke->miter_q8;
    const int32_t s = etch_mul_s32(in.x, out.y) < etch_mul_s32(in.y, out.x) ? 1 : -1;

    if (both <= 0 || 2 * h * h * 65536 > limit * both) {
        etch_join_bevel(o, p, in, out, stroke);
        return;
    }
    const int64_t x = s * h * h * (in.x + out.x), y = s * h * h * (in.y + out.y);
    const struct etch_point_q8 v[4] = {
        p, stroke_moved(p, s * in.x, s * in.y),
        stroke_moved(p, etch_divide_round_s64(x, both), etch_divide_round_s64(y, both)),
        stroke_moved(p, s * out.x, s * out.y)};

    etch_stroke_convex(o, v, 4);
}
