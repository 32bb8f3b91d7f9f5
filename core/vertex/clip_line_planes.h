/* vertex/clip_line_planes.h: what the line clippers share; no part of the API. */
#ifndef ETCH_VERTEX_CLIP_LINE_PLANES_H
#define ETCH_VERTEX_CLIP_LINE_PLANES_H

#include "transform.h"

/* The part of the line inside the planes |x| <= 2^shift[0] w, |y| <= 2^shift[1] w and |z| <= w, as
 * clip_line.h says. */
bool etch_clip_line_planes(const uint8_t shift[2], const struct etch_clip_vertex v[2],
                           struct etch_clip_vertex out[2]);

#endif
