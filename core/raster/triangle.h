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

/* Part one of set-up: the snapped triangle, sorted by (y, x), so that whatever follows does not
 * depend on the order of the caller's vertices. */
struct etch_triangle {
    struct etch_point_q8 p[3]; /* top, middle, bottom */
    uint64_t area;             /* twice the area in (1/256 px)^2, 1 .. 2^48 */
    int32_t x0, y0, x1, y1;    /* columns and rows whose centres it spans, half-open */
    uint8_t order[3];          /* p[i] is the caller's vertex order[i] */
    int8_t side;               /* +1 if p[1] lies right of the edge p[0] p[2], -1 left */
    int8_t winding;            /* as the caller ordered it, as seen: +1 clockwise, -1 counter-
                                  clockwise */
};

/* Sorts and measures a triangle. False if it has no area (then nothing is to be drawn and *t is
 * not to be used). Vertices must be in range. */
bool etch_triangle_setup(struct etch_triangle *t, const struct etch_point_q8 v[3]);

/* Whether the rows and columns that the triangle spans meet `clip`: a quick test before planes
 * are set up. */
ETCH_INLINE bool etch_triangle_is_visible(const struct etch_triangle *t,
                                          const struct etch_rect *clip)
{
    return t->y0 < clip->y1 && t->y1 > clip->y0 && t->x0 < clip->x1 && t->x1 > clip->x0 &&
           t->y0 < t->y1;
}

/* Hands the runs of `t` inside surface->clip to `paint`. Cost on ARMv6-M: some 60 instructions
 * for each of two or three edges, then 8 per edge and visible row; nothing for rows outside the
 * clip, and nothing at all if the columns miss it. */
void etch_triangle_runs(const struct etch_surface *surface, const struct etch_triangle *t,
                        const struct etch_paint *paint);

#endif
