/* draw/mesh_phong.h: set-up of Phong shading (fragment/phong.h) for triangles through stages. */
#ifndef ETCH_DRAW_MESH_PHONG_H
#define ETCH_DRAW_MESH_PHONG_H

#include "../fragment/phong.h"
#include "mesh_shaded.h"
#include "staged.h"

/* Normals and positions in perspective, of vertices that are struct etch_shade_vertex, into planes
 * that are struct etch_phong_planes. */
etch_varying etch_varying_shade;

#endif
