/* vertex/elements_points.c: lists of points. Called by draw/mesh_elements and by applications. See
 * elements.h. */
#include "elements_read.h"

void etch_elements_points(const struct etch_elements *elements, struct etch_element_sink *sink)
{
    elements_list(elements, sink, 1);
}
