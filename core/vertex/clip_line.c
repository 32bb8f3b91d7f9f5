/* vertex/clip_line.c: lines against near, far and guard planes. Called by assembly for the few
 * lines that cross one of them. See clip_line.h. */
#include "clip_line.h"
#include "clip_line_planes.h"

bool etch_clip_line(const struct etch_viewport *viewport, const struct etch_clip_vertex v[2],
                    struct etch_clip_vertex out[2])
{
    const uint8_t shift[2] = {viewport->guard_x, viewport->guard_y};

    return etch_clip_line_planes(shift, v, out);
}
