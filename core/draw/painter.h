/* draw/painter.h: hidden surfaces by the painter's algorithm: triangles sorted by depth, cut where
 * no order is right, and drawn from far to near; without a depth plane.
 *
 *      once a frame:      triangles -> &painter.sink -> the caller's buffer; etch_painter_sort
 *      for every strip:   etch_painter_draw -> a sink that rasterises
 *
 * Triangles are sorted by their farthest depth. Before one is drawn it is held against those that
 * overlap it in depth, by Newell's tests, from the cheapest on:
 *
 *      x extents apart; y extents apart; it lies wholly behind the other's plane; the other wholly
 *      in front of its plane; the pictures on the screen are apart.
 *
 * If all fail, the other is drawn first where the last two plane tests hold the other way round;
 * and where triangles pierce each other or overlap in a ring, one is cut along the plane of
 * another.
 *
 * Depth is linear on the screen, so all tests are in screen coordinates and exact, in integers.
 * Vertices of cuts are rounded: to 1/256 px, outwards, so that pieces cover all that the triangle
 * covered and at most 1/128 px beyond its edges, and their depth and colour by up to 16 / 65536 of
 * a unit and half a unit. Vertices within 2/256 px and 16 / 65536 of a unit of depth of a plane
 * count as on it. So the picture is that of a depth buffer except where, within 1/128 px of a
 * centre, depths tie to that measure or an edge of a triangle that was cut passes.
 *
 * Source: M. E. Newell, R. G. Newell, T. L. Sancha, "A solution to the hidden surface problem",
 * 1972. Buckets instead, without cuts: draw/ordering.h.
 */
#ifndef ETCH_DRAW_PAINTER_H
#define ETCH_DRAW_PAINTER_H

#include "../base/sink.h"

/* A triangle or a piece of one, 60 bytes. */
struct etch_painter_triangle {
    struct etch_vertex v[3];
    uint32_t z_far; /* the greatest depth of v */
    uint16_t next;  /* in the list that it is in */
    uint16_t whole; /* the triangle that it was cut from, whose plane it has; or itself */
    bool moved;     /* drawn earlier than its depth says */
};

#define ETCH_PAINTER_NONE UINT16_MAX

struct etch_painter {
    struct etch_sink sink; /* give &painter.sink to what emits triangles */
    struct etch_painter_triangle *triangle;
    uint16_t room;
    uint16_t count; /* of triangles, and of what cuts made of them */
    uint16_t lost;  /* of triangles that found no room, up to 65535 */
    uint16_t first; /* in the order of drawing, once sorted */
    bool uncut;     /* a cut found no room */
};

/* Empties *p over the caller's buffer of `room` triangles, 65534 at most. A triangle
 * takes one place, a cut two or three more. Triangles without area are not kept. */
void etch_painter_init(struct etch_painter *p, struct etch_painter_triangle *triangle,
                       uint16_t room);

/* Sorts and cuts what is kept, once, before it is drawn. ETCH_ENOMEM if a triangle was lost or a
 * cut found no room: what is kept is drawn all the same, in the order of its depth where it needed
 * the cut. Always ends: every step draws a triangle, cuts one, or moves one that was not moved
 * since the last cut. Cost: n log n for the order, then the tests of pairs that overlap in depth
 * and on the screen, from extents (a few comparisons) to plane tests (64-bit products). After
 * a cut the tests begin anew, and triangles that all pierce each other come to as many pieces as
 * the cube of their number, so give no more room than there is time for: a cut that finds none is
 * the last one that is tried. On a desktop 20000 small triangles, of which 1800 are cut, take
 * 0.02 s; 400 large ones that all pierce each other, 0.2 s with room for 4096, 7 s with room for
 * 16384, and minutes with room for 65534. */
enum etch_status etch_painter_sort(struct etch_painter *p);

/* Hands the triangles to to->triangle, from far to near. As often as wanted. */
void etch_painter_draw(const struct etch_painter *p, struct etch_sink *to);

#endif
