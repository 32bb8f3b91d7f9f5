/* vertex/elements.h: primitive assembly: which vertices make up which primitive.
 *
 *      named kind                     from vertices           gives
 *      etch_elements_points           0 1 2 3                 0, 1, 2, 3
 *      etch_elements_lines            0 1 2 3                 0 1, 2 3
 *      etch_elements_line_strip       0 1 2 3                 0 1, 1 2, 2 3
 *      etch_elements_line_loop        0 1 2 3                 0 1, 1 2, 2 3, 3 0
 *      etch_elements_triangles        0 1 2 3 4 5             0 1 2, 3 4 5
 *      etch_elements_triangle_strip   0 1 2 3 4               0 1 2, 2 1 3, 2 3 4
 *      etch_elements_triangle_fan     0 1 2 3 4               0 1 2, 0 2 3, 0 3 4
 *
 * Every triangle of a strip turns the same way. A flat one has the colour of the vertex that it
 * gives first. Vertices are 0, 1, 2, .. or an index list. An index that is not below `limit` ends
 * the strip, loop or fan, and the next begins a new one; in lists the primitive that it belongs to
 * is left out. What remains incomplete is left out. Who takes the primitives decides what becomes
 * of them: draw/mesh_elements.h draws, a struct of your own that begins with etch_element_sink does
 * as you like.
 */
#ifndef ETCH_VERTEX_ELEMENTS_H
#define ETCH_VERTEX_ELEMENTS_H

#include "../base/fixed.h"

struct etch_elements {
    const uint16_t *indices; /* the caller's; NULL: 0, 1, 2, .. */
    uint32_t count;          /* of them; without indices at most 65536 count */
    uint16_t limit;          /* vertices that there are */
};

/* Takes one primitive: 1, 2 or 3 indices below limit, valid during the call. */
struct etch_element_sink {
    void (*take)(struct etch_element_sink *sink, const uint16_t *index);
};

typedef void etch_element_kind(const struct etch_elements *elements,
                               struct etch_element_sink *sink);

etch_element_kind etch_elements_points;
etch_element_kind etch_elements_lines;
etch_element_kind etch_elements_line_strip;
etch_element_kind etch_elements_line_loop;
etch_element_kind etch_elements_triangles;
etch_element_kind etch_elements_triangle_strip;
etch_element_kind etch_elements_triangle_fan;

#endif
