/* base/sink.h: what the vertex stage hands on, a stream of screen-space triangles.
 *
 * The sink that rasterises is in draw/mesh.h. One that stores the triangles gives geometry
 * kept per frame, feedback or selection. */
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

struct etch_sink {
    /* Takes a triangle. The vertices are only valid during the call. */
    void (*triangle)(struct etch_sink *sink, const struct etch_vertex *const v[3]);
};

#endif
