/* raster/outline_smooth.c: outlines to smooth shapes. Named by applications. See outline.h. */
#include "outline.h"

void etch_outline_smooth(void *smooth, struct etch_point_q8 a, struct etch_point_q8 b)
{
    (void)etch_smooth_add_edge(smooth, a, b);
}
