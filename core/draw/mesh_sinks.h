/* draw/mesh_sinks.h: sinks that rasterise lines and points; draw/mesh.h has that of triangles. */
#ifndef ETCH_DRAW_MESH_SINKS_H
#define ETCH_DRAW_MESH_SINKS_H

#include "line.h"
#include "point.h"

struct etch_line_sink {
    struct etch_sink sink; /* give &it.sink to etch_assembly; takes lines only */
    const struct etch_surface *surface;
    etch_line_painter *painter; /* draw/line.h, with .. */
    etch_kernel *kernel;        /* .. a kernel that fits it */
};

struct etch_point_sink {
    struct etch_sink sink; /* takes points only */
    const struct etch_surface *surface;
    uint16_t size_q8;
    etch_point_runs *runs; /* etch_point_runs_square, _round */
    etch_kernel *kernel;   /* of gouraud.h */
};

/* These fill in all members. The surface stays the caller's and may be changed between calls. */
void etch_line_sink_init(struct etch_line_sink *lines, const struct etch_surface *surface,
                         etch_line_painter *painter, etch_kernel *kernel);
void etch_point_sink_init(struct etch_point_sink *points, const struct etch_surface *surface,
                          uint16_t size_q8, etch_point_runs *runs, etch_kernel *kernel);

#endif
