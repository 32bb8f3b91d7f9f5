/* raster/edge_flags.h: polygons by inverting a bit where an edge crosses a row.
 *
 * Instead of sorted edges it keeps one bit a pixel, so a polygon may have any number of edges and
 * nothing is sorted: each edge inverts, in every row that it crosses, the bit of its first pixel;
 * then a row is filled from an odd bit to the next. It is the even-odd rule, and the pixels are
 * those of etch_polygon_runs_evenodd (polygon.h).
 *
 *      etch_edge_flags_init, etch_edge_flags_add for every contour, etch_edge_flags_runs
 *
 * Source: B. D. Ackland, N. H. Weste, "The edge flag algorithm: a fill method for raster scan
 * displays", 1981, which inverts one pixel where older edge inversion inverts all that follow.
 */
#ifndef ETCH_RASTER_EDGE_FLAGS_H
#define ETCH_RASTER_EDGE_FLAGS_H

#include "polygon.h"

struct etch_edge_flags {
    uint8_t *bits;         /* pixel x of row y is bit 7 - (x - x0) % 8 of byte
                              (y - y0) * stride + (x - x0) / 8 */
    uint16_t stride;       /* bytes of a row: (width + 7) / 8 */
    struct etch_rect rect; /* pixels that the bits are for */
};

#define ETCH_EDGE_FLAGS_BYTES(width, height) (((size_t)(width) + 7) / 8 * (size_t)(height))

/* Clears the bits for `rect`, which is usually a strip or the box of the polygon: what is drawn is
 * inside it. `bits` stays the caller's. ETCH_EINVAL if the rectangle is empty, ETCH_ENOMEM if
 * `room` is less than ETCH_EDGE_FLAGS_BYTES of its size. */
enum etch_status etch_edge_flags_init(struct etch_edge_flags *f, struct etch_rect rect,
                                      uint8_t *bits, size_t room);

/* Inverts the edge between a and b, -2^23 .. 2^23. A row costs a step and a bit. */
void etch_edge_flags_add_edge(struct etch_edge_flags *f, struct etch_point_q8 a,
                              struct etch_point_q8 b);

/* The closed contour v[0] .. v[n - 1]. */
void etch_edge_flags_add(struct etch_edge_flags *f, const struct etch_point_q8 *v, uint16_t n);

/* Hands the runs inside surface->clip to the paint, in bands as polygon.h says. The bits stay. */
void etch_edge_flags_runs(const struct etch_surface *surface, const struct etch_edge_flags *f,
                          const struct etch_paint *paint);

#endif
