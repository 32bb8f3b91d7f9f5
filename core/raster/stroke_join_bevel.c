/* raster/stroke_join_bevel.c: joints cut off. Named in struct etch_stroke. See stroke.h. */
#include "stroke_parts.h"

void etch_join_bevel(const struct etch_outline *o, struct etch_point_q8 p, struct etch_point_q8 in,
                     struct etch_point_q8 out, const struct etch_stroke *stroke)
{
    const bool right = etch_mul_s32(in.x, out.y) < etch_mul_s32(in.y, out.x); /* bends left */
    const int32_t s = right ? 1 : -1;
    const struct etch_point_q8 v[3] = {p, stroke_moved(p, s * in.x, s * in.y),
                                       stroke_moved(p, s * out.x, s * out.y)};

    (void)stroke;
    etch_stroke_convex(o, v, 3);
}
