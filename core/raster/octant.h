/* raster/octant.h: what circle.c and disc.c share; no part of the API. */
#ifndef ETCH_RASTER_OCTANT_H
#define ETCH_RASTER_OCTANT_H

#include "circle.h"

/* The last x of the octant 0 <= x <= y(x):  x <= y(x)  <=>  2 x^2 - x < r^2. r is 1 .. 32767. It
 * is within one of r / sqrt(2), 46341 / 65536 = sqrt(1/2) (1 + 2^-17). */
ETCH_INLINE int32_t octant_end(int32_t r)
{
    int32_t x = (r * INT32_C(46341) >> 16) + 1;

    while (2 * x * x - x >= r * r)
        x--;
    return x;
}

#endif
