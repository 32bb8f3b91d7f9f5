/* vertex/elements_lines.c: lists of lines. Called by draw/mesh_elements and by applications. See
 * elements.h. */
#include "elements_read.h"

void etch_elements_lines(const struct etch_elements *elements, struct etch_element_sink *sink)
{
    elements_list(elements, sink, 2);
}
