/* vertex/varying.h: triangles whose vertices have more to them than position and colour: texture
 * coordinates, a normal, or whatever a painter interpolates.
 *
 *      clip space                      screen                     in a struct
 *      struct etch_clip_vertex         struct etch_vertex         .at
 *      int32_t [0]                     int32_t [0]                u
 *      int32_t [1]                     int32_t [1]                v
 *                                      uint32_t w                 w
 *      int32_t [2], [3] ..             int32_t [2], [3] ..        what you like
 *
 * `count` of these int32_t follow the vertex without a gap. Two of them are texture coordinates:
 * struct etch_clip_texture_vertex becomes struct etch_texture_vertex (base/texture.h). A vertex
 * with more is a struct that begins with these. The stage does not know what the numbers mean; the
 * sink gets pointers to the etch_vertex at their head and must expect the same struct.
 *
 * w is the distance from the eye that perspective needs: the clip w of vertices that are not
 * clipped; where a triangle is clipped, that of all its corners in one common unit, so that the
 * largest takes 32 bits. At a new corner each varying is the exact one on the plane rounded once,
 * half up, for every input, and w is within one of its units, at least 1.
 *
 * A program without textures links none of this: etch_assemble_triangle carries colours only.
 */
#ifndef ETCH_VERTEX_VARYING_H
#define ETCH_VERTEX_VARYING_H

#include "../base/texture.h"
#include "assembly.h"

/* Most varyings of a vertex. */
#define ETCH_VARYINGS 8

/* A vertex with texture coordinates in clip space. */
struct etch_clip_texture_vertex {
    struct etch_clip_vertex at; /* first */
    etch_q16 u, v;              /* texels */
};

/* Takes one triangle through reject, clip, project and cull (assembly.h) to assembly->sink, with
 * count = 2 .. ETCH_VARYINGS varyings behind each v[i] (other counts take the nearest). `flat`
 * concerns the colour alone. Every input is legal. About 1 KB of stack, and what the sink takes. */
void etch_assemble_varying(const struct etch_assembly *assembly,
                           const struct etch_clip_vertex *const v[3], uint8_t count);

/* Projects one vertex with count = 2 .. ETCH_VARYINGS varyings whose outcode has no bit of
 * ETCH_OUT_CLIP: out is followed by the varyings and w as above. */
void etch_varying_project(const struct etch_viewport *viewport, const struct etch_clip_vertex *in,
                          uint8_t count, struct etch_vertex *out);

/* The same as etch_assemble_varying with texture coordinates: the sink gets etch_texture_vertex. */
void etch_assemble_textured(const struct etch_assembly *assembly,
                            const struct etch_clip_texture_vertex v[3]);

#endif
