/* raster/polygon.h: polygons with holes, to runs, by scan lines.
 *
 * A polygon is any number of closed contours, in any order and winding, that may touch, cross and
 * overlap themselves and each other. A pixel's centre is asked how often the contours wind round
 * it, a centre on a left or top edge being inside and on a right or bottom edge outside:
 *
 *      even-odd   inside where a ray to the left crosses an odd number of edges
 *      non-zero   inside where edges going down and up along that ray do not cancel
 *
 * which is the rule of triangles (triangle.h): a triangle as a polygon is the same pixels, and
 * polygons that share an edge neither overlap nor leave a gap. Exact for all vertices in range.
 *
 *      etch_polygon_init       over the caller's edges
 *      etch_polygon_add        a contour, once for each; curves: curve.h
 *      etch_polygon_runs_..    as often as wanted, once a strip
 *
 * A polygon without memory for its edges: edge_flags.h. One colour in one call: draw/polygon.h.
 * Runs come in bands of up to 32 rows, within a band the first runs of its rows, then the second
 * ones: each pixel once. Source: B. W. Jordan, B. C. Barrett, "A scan conversion algorithm with
 * reduced storage requirements", 1973; rows by quotient and remainder, as in triangle.c.
 */
#ifndef ETCH_RASTER_POLYGON_H
#define ETCH_RASTER_POLYGON_H

#include "line.h"
#include "triangle.h"

/* One edge, 36 bytes where a pointer has 4. It remembers the row where it was walked to last, from
 * which the strip below goes on: whatever that was, the pixels are the same. */
struct etch_polygon_edge {
    struct etch_polygon_edge *next; /* to the right, while it is walked */
    int32_t x, e;                   /* row y: first pixel at or right of it; excess, 0 .. dy - 1 */
    int32_t dy;                     /* 1 .. 2^24 */
    int32_t quotient, remainder;    /* of dx / dy */
    int16_t y0, y1, y;              /* rows whose centres it crosses, half-open; where it is */
    int16_t left;                   /* column that it never reaches beyond to the left */
    int8_t winding;                 /* +1 down, -1 up */
};

struct etch_polygon {
    struct etch_polygon_edge *edge;
    uint16_t room, count;
    bool sorted;
    enum etch_status status; /* of all that was added: the first failure */
};

/* An empty polygon over the caller's buffer of `room` edges, which stays the caller's and must
 * stay valid while the polygon is used. A contour of n vertices needs n edges at most: those that
 * cross no row of pixel centres, horizontal ones too, take none. */
void etch_polygon_init(struct etch_polygon *p, struct etch_polygon_edge *edge, uint16_t room);

/* Adds one edge. The edges of a polygon must make closed contours when it is drawn; else rows
 * have an open end, and what is right of it is filled or not, inside the clip all the same.
 * ETCH_EINVAL if an end is not within -2^23 .. 2^23, ETCH_ENOMEM if there is no room: from then on
 * the polygon draws nothing, and every call returns the first failure. */
enum etch_status etch_polygon_add_edge(struct etch_polygon *p, struct etch_point_q8 a,
                                       struct etch_point_q8 b);

/* Adds the closed contour v[0] .. v[n - 1]; the last edge goes back to v[0]. Fewer than 3 vertices
 * have no area, and add nothing. */
enum etch_status etch_polygon_add(struct etch_polygon *p, const struct etch_point_q8 *v,
                                  uint16_t n);

/* The same for vertices at the centres of pixels; every int16_t is legal. */
enum etch_status etch_polygon_add_pixels(struct etch_polygon *p, const struct etch_point *v,
                                         uint16_t n);

/* Hands the runs inside surface->clip to the paint. The first call sorts the edges by their rows.
 * Cost: nothing for rows outside the clip or between contours; a 64-bit division for each edge that
 * is cut by the top of the clip, none where a strip continues the one above; then, for edges that
 * are not right of the clip, a step an edge and row, and an insertion where edges cross. */
void etch_polygon_runs_evenodd(const struct etch_surface *surface, struct etch_polygon *p,
                               const struct etch_paint *paint);
void etch_polygon_runs_nonzero(const struct etch_surface *surface, struct etch_polygon *p,
                               const struct etch_paint *paint);

#endif
