/* vertex/clip_line_volume.c: lines against all six planes. Called by applications. See
 * clip_line.h. */
#include "clip_line.h"
#include "clip_line_planes.h"

bool etch_clip_line_volume(const struct etch_clip_vertex v[2], struct etch_clip_vertex out[2])
{
    const uint8_t shift[2] = {0, 0};

    return etch_clip_line_planes(shift, v, out);
}
