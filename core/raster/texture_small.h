/* raster/texture_small.h: texture coordinates in perspective for programs that count bytes. */
#ifndef ETCH_RASTER_TEXTURE_SMALL_H
#define ETCH_RASTER_TEXTURE_SMALL_H

#include "../base/texture.h"
#include "plane_small.h"

/* As etch_texture_perspective (texture_plane.h) with exact planes, for kernels that divide at every
 * pixel. p[i] is the position of vertex[i], which have an area. */
void etch_texture_perspective_small(struct etch_perspective_planes *planes,
                                    const struct etch_point_q8 p[3],
                                    const struct etch_texture_vertex *const vertex[3]);

#endif
