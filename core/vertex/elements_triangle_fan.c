/* vertex/elements_triangle_fan.c: triangles round their first vertex. Called by draw/mesh_elements
 * and by applications. See elements.h. */
#include "elements_read.h"

void etch_elements_triangle_fan(const struct etch_elements *elements,
                                struct etch_element_sink *sink)
{
    uint16_t index[3] = {0, 0, 0};
    uint8_t have = 0;

    for (uint32_t i = 0; i < elements->count; i++) {
        if (!elements_read(elements, i, &index[2])) {
            have = 0;
        } else if (have < 2) {
            index[have++] = index[2];
        } else {
            sink->take(sink, index);
            index[1] = index[2];
        }
    }
}
