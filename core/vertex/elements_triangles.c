/* vertex/elements_triangles.c: lists of triangles. Called by draw/mesh_elements and by
 * applications. See elements.h. */
#include "elements_read.h"

void etch_elements_triangles(const struct etch_elements *elements, struct etch_element_sink *sink)
{
    elements_list(elements, sink, 3);
}
