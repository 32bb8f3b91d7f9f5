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

/* The same in two halves, so that the vertices in clip space need not stand on the stack while the
 * sink draws. The first rejects, clips and projects to out (room for ETCH_CLIP_MAX) and returns the
 * number of corners, 0 or 3 .. ETCH_CLIP_MAX; the second culls and hands them on, as
 * etch_assemble_fan does. */
uint8_t etch_assemble_polygon(const struct etch_assembly *assembly,
                              const struct etch_clip_vertex v[3],
                              struct etch_vertex out[ETCH_CLIP_MAX]);
void etch_assemble_projected(const struct etch_assembly *assembly, const struct etch_vertex *v,
                             uint8_t n);

/* The last part: projects the convex polygon v[0 .. n-1], n = 0 or 3 .. ETCH_CLIP_MAX, and hands
 * it on as n - 2 triangles, a fan round v[0]. Rounding to 1/256 px can turn a flat corner inwards;
 * ears are then cut off where they cover nothing else, so that the triangles cover the snapped
 * outline and each pixel once. (Slivers whose snapped outline crosses itself lose the part that
 * turned over, less than 1/256 px wide.) Source: G. Meisters, "Polygons have ears", 1975. */
void etch_assemble_fan(const struct etch_assembly *assembly, const struct etch_clip_vertex *v,
                       uint8_t n);

#endif
