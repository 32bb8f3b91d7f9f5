/* raster/line_clip.h: lines cut at a rectangle, as geometry.
 *
 * Drawing needs none of this: what raster/ draws is clipped to the surface exactly. It is for
 * programs that want the visible part itself: to store it, to label it, to draw it with something
 * else.
 *
 * Coordinates are of any unit, every int32_t is legal, and the rectangle is closed. Each cut is
 * the exact meeting point of the whole line with one side: on that side exactly, along it rounded
 * to the nearest unit, half up. What is outside is decided without rounding. So neither the
 * direction of the line nor the order of the sides changes anything, and both algorithms give the
 * same ends.
 */
#ifndef ETCH_RASTER_LINE_CLIP_H
#define ETCH_RASTER_LINE_CLIP_H

#include "../base/fixed.h"

struct etch_point_s32 {
    int32_t x, y;
};

/* x0 <= x <= x1 and y0 <= y <= y1; x0 <= x1 and y0 <= y1. INT32_MIN and INT32_MAX: no side. */
struct etch_bounds {
    int32_t x0, y0, x1, y1;
};

/* Cuts the line p[0] p[1] to the bounds, in place and in its direction. False, and p as it was, if
 * it misses them; a line that touches them in a point becomes that point.
 *
 * By outcodes: an end outside moves to a side that it is outside of until both are inside or both
 * outside of one. Quick where most lines are wholly inside or wholly outside one side. At most
 * four products of 32 bits each side, and one 64-bit division for each cut that is left.
 * Source: D. Cohen, I. Sutherland, 1967, in W. Newman, R. Sproull, "Principles of interactive
 * computer graphics", 1973. */
bool etch_line_clip_cohen_sutherland(const struct etch_bounds *bounds, struct etch_point_s32 p[2]);

/* The same by the parameters at which the line enters and leaves the sides, ordered by products
 * without a division. Quick where most lines are cut. Two products for each side but the first,
 * and one 64-bit division for each cut that is left.
 * Source: Y.-D. Liang, B. Barsky, "A new concept and method for line clipping", 1984. */
bool etch_line_clip_liang_barsky(const struct etch_bounds *bounds, struct etch_point_s32 p[2]);

#endif
