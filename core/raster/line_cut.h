/* raster/line_cut.h: where a line meets a side of a rectangle; no part of the API.
 *
 * Points are pairs {x, y} here, so that an axis is an index. The line a b crosses the side
 * `axis coordinate = at`, which lies between a's and b's, ends included; they differ there. */
#ifndef ETCH_RASTER_LINE_CUT_H
#define ETCH_RASTER_LINE_CUT_H

#include "../base/fixed.h"

/* The sign of the other coordinate there less `bound`, exactly. */
int8_t etch_line_cut_compare(const int32_t a[2], const int32_t b[2], uint8_t axis, int32_t at,
                             int32_t bound);

/* The other coordinate there, rounded half up; the same from b to a. */
int32_t etch_line_cut_round(const int32_t a[2], const int32_t b[2], uint8_t axis, int32_t at);

/* |a - b|, which fits. */
ETCH_INLINE uint32_t etch_line_cut_distance(int32_t a, int32_t b)
{
    return a < b ? etch_wrap_sub((uint32_t)b, (uint32_t)a)
                 : etch_wrap_sub((uint32_t)a, (uint32_t)b);
}

#endif
