/* vertex/assembly_small.h: clip, project, cull for programs that count bytes. */
#ifndef ETCH_VERTEX_ASSEMBLY_SMALL_H
#define ETCH_VERTEX_ASSEMBLY_SMALL_H

#include "assembly.h"

/* As etch_assemble_triangle (assembly.h); a triangle that crosses no plane gives the same bits.
 * One that does is cut plane by plane (near, far, then the guard planes of viewport.h), its new
 * corners rounded to 30 bits each time and colours to whole steps, and handed on as the fan round
 * its first corner. A corner is within 1/16 px of the exact one where the coordinates of an edge's
 * two ends are of sizes within a factor of 2^11; clip.h is exact for every input. Corners on an
 * edge of the triangle depend on that edge alone, from its inside to its outside end, so neighbours
 * share them unless two planes cut the edge between them. */
void etch_assemble_triangle_small(const struct etch_assembly *assembly,
                                  const struct etch_clip_vertex v[3]);

#endif
