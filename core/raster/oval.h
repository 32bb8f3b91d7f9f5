/* raster/oval.h: half the width of an ellipse or a disc, row by row; no part of the API.
 *
 * A pixel `a` columns and `b` rows off the centre is in the ellipse if a step of half a pixel
 * towards the centre, across or down, leads into x^2 / rx^2 + y^2 / ry^2 <= 1 (ellipse.h). On a row
 * these are the columns 0 .. w(b), and w never grows with b.
 */
#ifndef ETCH_RASTER_OVAL_H
#define ETCH_RASTER_OVAL_H

#include "rows.h"

struct etch_oval {
    int32_t rx, ry;       /* 0 .. 32767 */
    uint32_t down, right; /* rx^2 and ry^2; 1 and 1 of a circle */
    int32_t least, most;  /* widths are held to these: what is beyond cannot be seen */
};

/* Half the width of one row 0 .. ry, to be moved to the next. */
struct etch_oval_edge {
    int32_t w, b;
    int64_t f, g;            /* of (w, b), see oval.c */
    int64_t f_right, f_down; /* what they grow by */
};

/* An oval that reaches rx to the left of column x0 and to the right of x1 >= x0, and of which only
 * the columns of `view` and those next to it matter. False if none of it lies in them, or rx or ry
 * is below 0. */
bool etch_oval_init(struct etch_oval *o, int32_t x0, int32_t x1, int32_t rx, int32_t ry,
                    struct etch_span view);

/* On no row yet, and next to none. */
ETCH_INLINE void etch_oval_edge_init(struct etch_oval_edge *e)
{
    e->b = -2;
}

/* w(b) for b >= 0, -1 beyond ry. To the next row by sums, elsewhere by 15 halvings. */
int32_t etch_oval_width(const struct etch_oval *o, struct etch_oval_edge *e, int32_t b);

#endif
