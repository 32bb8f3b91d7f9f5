/* raster/smooth.h: polygons with holes, to the share of each pixel that they cover.
 *
 * A row of pixels is cut by 16 lines at the heights (2 k + 1) / 32. On each line the inside of the
 * polygon, by the even-odd or the non-zero rule, is a set of intervals whose ends are exact to
 * 1/256 px (rounded down); the cover of a pixel is the sum of what they take of it, 0 .. 4096.
 * Inside is counted once however often contours overlap, so a shape that meets itself is not
 * blended twice, and of shapes that share an edge the covers add up to exactly 4096. Each edge
 * makes a pixel's cover differ from the true area by 1/32 at most, where it is nearly level, and by
 * 1/256 + 1/512 where it is steep. Strips and clips change nothing.
 *
 *      etch_smooth_init, etch_smooth_add ..      over the caller's edges, as polygon.h
 *      etch_smooth_fill_nonzero, .._evenodd      hands covers to a paint, once a strip
 *
 * Curved outlines and thick lines: smooth_shapes.h; colours: fragment/cover.h.
 * Source: horizontally exact, vertically sampled coverage, as L. Carpenter, "The A-buffer", 1984,
 * masks.
 */
#ifndef ETCH_RASTER_SMOOTH_H
#define ETCH_RASTER_SMOOTH_H

#include "../base/cover.h"
#include "polygon.h"

/* One edge, 44 bytes where a pointer has 4. */
struct etch_smooth_edge {
    struct etch_smooth_edge *next;
    struct etch_point_q8 a; /* upper end */
    int32_t dx, dy;         /* to the lower one; dy 1 .. 2^24 */
    int32_t x, e;           /* on the line in hand: floor, remainder 0 .. dy - 1 */
    int32_t line0, line1;   /* lines that it crosses, half-open: 16 a row */
    int8_t winding;
};

struct etch_smooth {
    struct etch_smooth_edge *edge;
    uint16_t room, count;
    int32_t line0, line1;    /* edges that cross none of these lines are left out */
    enum etch_status status; /* the first failure: then nothing is drawn */
};

/* An empty shape over the caller's `room` edges, which stay the caller's. */
void etch_smooth_init(struct etch_smooth *p, struct etch_smooth_edge *edge, uint16_t room);

/* From here on edges beside the rows of surface->clip take no room: for a shape that is added anew
 * for each strip, room for the edges that cross 16 rows will do. What is filled within these rows
 * is the same. */
void etch_smooth_window(struct etch_smooth *p, const struct etch_surface *surface);

/* Adds an edge of closed contours; ends within -2^23 .. 2^23 or ETCH_EINVAL; ETCH_ENOMEM without
 * room. Edges that cross no line take none. */
enum etch_status etch_smooth_add_edge(struct etch_smooth *p, struct etch_point_q8 a,
                                      struct etch_point_q8 b);

/* Adds the closed contour v[0] .. v[n - 1]; fewer than 3 vertices add nothing. */
enum etch_status etch_smooth_add(struct etch_smooth *p, const struct etch_point_q8 *v, uint16_t n);

/* Hands over the covers inside surface->clip. `cover` is the caller's for the call: as many
 * elements as the clip is wide, and one. Cost: each edge is looked at once a row; one that crosses
 * the row takes a 64-bit division there and a 32-bit one a line. Pixels between the shape's first
 * and last of a row are read once. */
void etch_smooth_fill_nonzero(const struct etch_surface *surface, struct etch_smooth *p,
                              const struct etch_cover_paint *paint, int16_t *cover);
void etch_smooth_fill_evenodd(const struct etch_surface *surface, struct etch_smooth *p,
                              const struct etch_cover_paint *paint, int16_t *cover);

#endif
