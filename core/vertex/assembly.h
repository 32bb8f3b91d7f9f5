/* vertex/assembly.h: three vertices in clip space to triangles in a sink:
 *
 *      reject -> clip where needed -> project -> cull -> sink->triangle
 *
 * A triangle wholly outside one plane of the view volume is rejected; one that crosses near, far
 * or a guard plane is clipped into a fan; the sides are left to the rasteriser's scissor.
 */
#ifndef ETCH_VERTEX_ASSEMBLY_H
#define ETCH_VERTEX_ASSEMBLY_H

#include "clip.h"
#include "cull.h"

struct etch_assembly {
    struct etch_viewport viewport;
    enum etch_cull cull;
    bool flat;              /* every triangle wholly in the colour of its vertex 0 */
    struct etch_sink *sink; /* the caller's */
};

/* Takes one triangle through all of the above. Every input is legal. */
void etch_assemble_triangle(const struct etch_assembly *assembly,
                            const struct etch_clip_vertex v[3]);

/* The last part: projects the convex polygon v[0 .. n-1], n = 3 .. ETCH_CLIP_MAX, and hands it
 * on as a fan. Rounding to 1/256 px can turn a flat corner inwards; the fan starts at the first
 * corner from which no triangle turns over, so that it covers the snapped outline and each
 * pixel once. (At v[0] if there is none, which takes two such corners.) */
void etch_assemble_fan(const struct etch_assembly *assembly, const struct etch_clip_vertex *v,
                       uint8_t n);

#endif
