/* raster/outline_polygon.c: outlines to polygons. Named by applications. See outline.h. */
#include "outline.h"

void etch_outline_polygon(void *polygon, struct etch_point_q8 a, struct etch_point_q8 b)
{
    (void)etch_polygon_add_edge(polygon, a, b);
}
