/* vertex/assembly_line.h: lines and points in clip space to a sink. */
#ifndef ETCH_VERTEX_ASSEMBLY_LINE_H
#define ETCH_VERTEX_ASSEMBLY_LINE_H

#include "assembly.h"

/* Takes one line through reject, clip (clip_line.h) and project to assembly->sink->line; `flat`
 * gives both ends the colour of v[0]. Every input is legal. */
void etch_assemble_line(const struct etch_assembly *assembly, const struct etch_clip_vertex v[2]);

/* Takes one point to assembly->sink->point, if its centre lies between near and far and not beyond
 * a guard plane: a large point reaches into the picture from beside it. */
void etch_assemble_point(const struct etch_assembly *assembly, const struct etch_clip_vertex *v);

#endif
