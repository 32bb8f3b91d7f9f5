/* base/sink.h: what the vertex stage hands on, a stream of screen-space triangles, lines and
 * points.
 *
 * The sink that rasterises is in draw/mesh.h. One that stores the primitives gives geometry
 * kept per frame, feedback or selection. A vertex with more to it (texture coordinates, a normal)
 * is a struct that begins with an etch_vertex; source and sink of the stream agree on which. */
#ifndef ETCH_BASE_SINK_H
#define ETCH_BASE_SINK_H

#include "fixed.h"

/* A projected, lit vertex. */
struct etch_vertex {
    int32_t x_q8, y_q8; /* frame position in 1/256 px, -2^23 .. 2^23; y down; pixel (i, j)
                           has its centre at (256 i + 128, 256 j + 128) */
    uint32_t z_q16;     /* depth, 0 (near) .. 65535.0 (far), 16 fraction bits */
    uint8_t r, g, b, a; /* colour, 0 .. 255 */
};

/* Each takes one primitive. The vertices are only valid during the call. A kind that the source
 * does not emit may be NULL. */
struct etch_sink {
    void (*triangle)(struct etch_sink *sink, const struct etch_vertex *const v[3]);
    void (*line)(struct etch_sink *sink, const struct etch_vertex *const v[2]);
    void (*point)(struct etch_sink *sink, const struct etch_vertex *v);
};

#endif
