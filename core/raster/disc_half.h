/* raster/disc_half.h: half the width of a disc, row by row; no part of the API.
 *
 * As oval.h with rx = ry, for rings and arcs: with equal radii a pixel `a` columns and `b` rows off
 * the centre is in the disc of radius r iff a^2 + b^2 - r^2 < max(a, b), which 32 bits hold: both
 * squares are at most 32767^2.
 */
#ifndef ETCH_RASTER_DISC_HALF_H
#define ETCH_RASTER_DISC_HALF_H

#include "rows.h"

/* Widths are held to these: what is beyond cannot be seen. */
struct etch_disc_view {
    int32_t near, far; /* 0 <= near, far */
};

/* Of the rows 0 .. r the columns 0 .. w, kept for one row and moved to the next. */
struct etch_disc_half {
    int32_t r;       /* 0 .. 32767, or -1: no row */
    int32_t w, b, e; /* e = w^2 + b^2 - r^2 */
};

/* Where the columns x0 .. x1 - 1 are, off column x. */
void etch_disc_view_init(struct etch_disc_view *view, int32_t x, int32_t x0, int32_t x1);

/* False if nothing of the disc can be seen, or r is below 0. */
bool etch_disc_half_init(struct etch_disc_half *h, const struct etch_disc_view *view, int32_t r);

/* w(b) for b >= 0, -1 beyond r. To the next row by sums, elsewhere by 15 halvings. */
int32_t etch_disc_half_width(struct etch_disc_half *h, const struct etch_disc_view *view,
                             int32_t b);

#endif
