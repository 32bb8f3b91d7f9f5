/* raster/triangle.h: triangle set-up and the edge walk, any triangle to runs.
 *
 * A pixel is covered iff its centre is inside, or on a top or left edge, of the triangle whose
 * vertices are in 1/256 px. True for every triangle in range, both windings and all vertex
 * orders; a mesh covers each pixel once. Zero area covers nothing.
 */
#ifndef ETCH_RASTER_TRIANGLE_H
#define ETCH_RASTER_TRIANGLE_H

#include "../base/paint.h"

struct etch_point_q8 {
    int32_t x, y; /* 1/256 px, -2^23 .. 2^23 */
};

/* Part one of set-up: the snapped triangle, sorted by (y, x), so that whatever follows does
 * not depend on the order of the caller's vertices. */
struct etch_triangle {
    struct etch_point_q8 p[3]; /* top, middle, bottom */
    uint8_t order[3];          /* p[i] is the caller's vertex order[i] */
    int8_t side;               /* sign of the doubled area of p: +1 the middle vertex lies right
                                  of the edge p[0] p[2], -1 left */
    int8_t winding;            /* as the caller ordered it, as seen: +1 clockwise, -1 counter-
                                  clockwise */
    int16_t y0, y1;            /* rows whose centres the triangle spans, y0 <= y < y1 */
    int32_t least, most;       /* of the x of p */
    uint64_t area;             /* twice the area in (1/256 px)^2, 1 .. 2^48 */
};

/* Sorts and classifies a triangle. False if it has no area (then nothing is to be drawn and
 * *t is not to be used). Vertices must be in range. */
bool etch_triangle_setup(struct etch_triangle *t, const struct etch_point_q8 v[3]);

/* Whether the rows and columns that the triangle spans meet `clip`: a quick test before planes
 * are set up. */
bool etch_triangle_is_visible(const struct etch_triangle *t, struct etch_rect clip);

/* Hands the runs of `t` inside surface->clip to `paint`. Cost: set-up of two or three edges,
 * then about 8 instructions (ARMv6-M) per edge and visible row; nothing for rows and columns
 * outside the clip. */
void etch_triangle_runs(const struct etch_surface *surface, const struct etch_triangle *t,
                        const struct etch_paint *paint);

#endif
