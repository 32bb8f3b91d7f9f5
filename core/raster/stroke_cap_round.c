/* raster/stroke_cap_round.c: ends with half a disc. Named in struct etch_stroke. See stroke.h. */
#include "stroke_parts.h"

void etch_cap_round(const struct etch_outline *o, struct etch_point_q8 p, struct etch_point_q8 in,
                    struct etch_point_q8 out, const struct etch_stroke *stroke)
{
    (void)in, (void)out;
    etch_outline_ellipse(o, p, stroke->width_q8 / 2, stroke->width_q8 / 2, false);
}
