/* raster/stroke_cap_butt.c: ends where the line ends. Named in struct etch_stroke. See stroke.h. */
#include "stroke_parts.h"

void etch_cap_butt(const struct etch_outline *o, struct etch_point_q8 p, struct etch_point_q8 in,
                   struct etch_point_q8 out, const struct etch_stroke *stroke)
{
    (void)o, (void)p, (void)in, (void)out, (void)stroke;
}
