/* vertex/elements_triangle_strip.c: triangles of which each shares an edge with the one before.
 * Called by draw/mesh_elements and by applications. See elements.h. */
#include "elements_read.h"

void etch_elements_triangle_strip(const struct etch_elements *elements,
                                  struct etch_element_sink *sink)
{
    uint16_t index[3] = {0, 0, 0};
    uint8_t have = 0;
    bool odd = false;

    for (uint32_t i = 0; i < elements->count; i++) {
        if (!elements_read(elements, i, &index[2])) {
            have = 0;
            odd = false;
        } else if (have < 2) {
            index[have++] = index[2];
        } else {
            sink->take(sink, index);
            /* 0 1 2 is followed by 2 1 3, and that by 2 3 4 */
            index[odd ? 1 : 0] = index[2];
            odd = !odd;
        }
    }
}
