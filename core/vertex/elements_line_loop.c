/* vertex/elements_line_loop.c: lines from vertex to vertex and back to the first. Called by
 * draw/mesh_elements and by applications. See elements.h. */
#include "elements_read.h"

/* Two vertices make a line there and one back, one makes none. */
static void close(struct etch_element_sink *sink, uint16_t last, uint16_t first, uint32_t lines)
{
    const uint16_t index[2] = {last, first};

    if (lines != 0)
        sink->take(sink, index);
}

void etch_elements_line_loop(const struct etch_elements *elements, struct etch_element_sink *sink)
{
    uint16_t index[2] = {0, 0}, first = 0;
    uint32_t lines = 0;
    bool begun = false;

    for (uint32_t i = 0; i < elements->count; i++) {
        const bool ok = elements_read(elements, i, &index[1]);

        if (ok && begun) {
            sink->take(sink, index);
            lines++;
        } else {
            close(sink, index[0], first, lines);
            first = index[1];
            lines = 0;
        }
        index[0] = index[1];
        begun = ok;
    }
    close(sink, index[0], first, lines);
}
