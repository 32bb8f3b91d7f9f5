/* vertex/elements_line_strip.c: lines from vertex to vertex. Called by draw/mesh_elements and by
 * applications. See elements.h. */
#include "elements_read.h"

void etch_elements_line_strip(const struct etch_elements *elements, struct etch_element_sink *sink)
{
    uint16_t index[2] = {0, 0};
    bool begun = false;

    for (uint32_t i = 0; i < elements->count; i++) {
        const bool ok = elements_read(elements, i, &index[1]);

        if (ok && begun)
            sink->take(sink, index);
        index[0] = index[1];
        begun = ok;
    }
}
