/* raster/clip_polygon.h: polygons of any size cut at a rectangle, in constant memory.
 *
 * Four planes stand in a row, and each hands vertices on to the next as they come; no polygon is
 * stored between them:
 *
 *      vertex --> left --> right --> top --> bottom --> your function
 *
 * Coordinates are of any unit, every int32_t is legal, and the rectangle is closed. As in
 * line_clip.h a cut is the exact meeting point of a whole edge with one side, rounded half up along
 * it, so polygons that share an edge get the same cuts, and what is outside is decided without
 * rounding. Concave and self-crossing polygons are legal: where they fall apart, the parts are
 * joined by pairs of edges along the sides that enclose nothing under either fill rule. A vertex
 * may come twice in a row.
 * Source: I. Sutherland, G. Hodgman, "Reentrant polygon clipping", 1974.
 */
#ifndef ETCH_RASTER_CLIP_POLYGON_H
#define ETCH_RASTER_CLIP_POLYGON_H

#include "line_clip.h"

/* Takes the vertices of what is left, in the order of the polygon. */
typedef void etch_polygon_vertex_function(void *context, struct etch_point_s32 p);

/* One plane, and what it remembers. */
struct etch_clip_plane {
    uint8_t axis; /* 0 x, 1 y */
    bool upper;   /* inside is coordinate <= at, else >= */
    bool any, first_inside, last_inside;
    int32_t at;
};

/* A polygon on its way; some 70 bytes, the caller's. Members are private. */
struct etch_clip_polygon {
    struct etch_clip_plane plane[4];
    struct etch_point_s32 first, last;
    bool any;
    etch_polygon_vertex_function *function;
    void *context;
};

/* Starts a polygon. */
void etch_clip_polygon_begin(struct etch_clip_polygon *clip, const struct etch_bounds *bounds,
                             etch_polygon_vertex_function *function, void *context);

/* Its next vertex. Calls the function 0 to 5 times. */
void etch_clip_polygon_vertex(struct etch_clip_polygon *clip, struct etch_point_s32 p);

/* Closes it; then it may begin again. */
void etch_clip_polygon_end(struct etch_clip_polygon *clip);

#endif
