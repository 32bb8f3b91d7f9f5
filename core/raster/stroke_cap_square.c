/* raster/stroke_cap_square.c: ends half a width longer. Named in struct etch_stroke. See stroke.h.
 */
#include "stroke_parts.h"

void etch_cap_square(const struct etch_outline *o, struct etch_point_q8 p, struct etch_point_q8 in,
                     struct etch_point_q8 out, const struct etch_stroke *stroke)
{
    (void)out, (void)stroke;
    etch_stroke_segment(o, p, stroke_moved(p, in.y, -in.x), in);
}
