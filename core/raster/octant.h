/* raster/octant.h: the octant that circles are made of; no part of the API.
 *
 * In the octant 0 <= x <= y the circle's pixels are (x, y(x)) with
 *
 *      (y - 1/2)^2 < r^2 - x^2 < (y + 1/2)^2        never equal: 1/4 is no integer
 *
 * for x up to the last with x <= y(x). y never grows, so a clip rectangle is an interval of x
 * in each octant, found by square roots, and a walk needs no test per pixel.
 */
#ifndef ETCH_RASTER_OCTANT_H
#define ETCH_RASTER_OCTANT_H

#include "circle.h"

/* Columns x of the octant, both ends included. */
struct etch_octant_part {
    int32_t from, to;
};

/* The last x of the octant 0 <= x <= y(x):  x <= y(x)  <=>  2 x^2 - x < r^2. r is 1 .. 32767. It
 * is within one of r / sqrt(2), 46341 / 65536 = sqrt(1/2) (1 + 2^-17). */
ETCH_INLINE int32_t octant_end(int32_t r)
{
    int32_t x = (r * INT32_C(46341) >> 16) + 1;

    while (2 * x * x - x >= r * r)
        x--;
    return x;
}

/* Whether y(end) = end: then both octants at the diagonal have that pixel. */
ETCH_INLINE bool octant_meets_diagonal(int32_t r, int32_t end)
{
    return r * r <= 2 * end * end + end;
}

ETCH_INLINE bool octant_has(const struct etch_octant_part *part)
{
    return part->from <= part->to;
}

/* Cuts a part to lo <= x <= hi. */
ETCH_INLINE void octant_cut_x(struct etch_octant_part *part, int32_t lo, int32_t hi)
{
    part->from = lo > part->from ? lo : part->from;
    part->to = hi < part->to ? hi : part->to;
}

/* Cuts a part to where lo <= y(x) <= hi; one or two square roots where that cuts. */
void etch_octant_cut_y(struct etch_octant_part *part, int32_t lo, int32_t hi, int32_t r);

/* Where a walk stands, at (x, y) of the octant: d = F(x, y - 1/2) - 1/4 with F = x^2 + y^2 - r^2. A
 * step to the right adds 2 x - 1; if d is not below 0 then, the midpoint is outside, y falls and d
 * loses 2 y - 2. |d| <= 2^17 for r <= 32767. */
struct etch_octant_pen {
    int32_t right, down, d; /* 2 x - 1, 2 y - 2 */
};

/* The pen at (x, y(x)); returns y(x). */
int32_t etch_octant_start(struct etch_octant_pen *pen, int32_t x, int32_t r);

/* Goes on from p, which is written, to column `to`; returns the pixel there. A column further is
 * `along` elements, y + 1 is `across`. Steps before it writes, so that p never leaves the clip. */
uint16_t *etch_octant_walk(struct etch_octant_pen *pen, uint16_t *p, ptrdiff_t along,
                           ptrdiff_t across, int32_t to, uint16_t color);

/* A circle that is inside the window: r > 0, octant_end, and the last x of the octants whose rows
 * are x from the centre's. */
void etch_circle_whole(uint16_t *centre, ptrdiff_t row, int32_t r, int32_t end, int32_t steep_end,
                       uint16_t color);

#endif
