/* raster/sector.h: the part of each row between two rays from a pixel; no part of the API.
 *
 * A pixel (dx, dy) off the centre is in the sector iff its direction is at or clockwise after the ray `from`
 * and before the ray `to`; the centre itself counts as the direction 0. Rays are vectors of 30 bits
 * (base/trig.h), and sides are told by the sign of a cross product: exactly.
 */
#ifndef ETCH_RASTER_SECTOR_H
#define ETCH_RASTER_SECTOR_H

#include "rows.h"

/* The line through the centre along a ray: the columns below `cut` are on one side of it. */
struct etch_sector_ray {
    int32_t dx, dy;              /* along it, dy >= 0 */
    int64_t x;                   /* row `b`: floor of b dx / dy */
    int32_t e;                   /* and remainder */
    int32_t quotient, remainder; /* of stride dx / dy */
    bool clockwise_is_left;      /* what is clockwise of the ray has the smaller columns */
};

struct etch_sector {
    struct etch_sector_ray first, last;
    bool all, inverted; /* everything; all but what is between the rays */
    int32_t b;          /* the row, from the centre, where the rays are */
    int32_t stride;     /* to the next */
};

/* From the angle `from` on, `sweep` 65536ths of a turn, 1 or more; 65536 or more are all. Rows and columns are in
 * any unit, within -2^25 .. 2^25; rows are asked for `stride` = 1 .. 16 after another. */
void etch_sector_init(struct etch_sector *s, uint16_t from, uint32_t sweep, int32_t stride);

/* Adds to `row` what of x0 <= x < x1 is in the sector, b rows below its centre in column cx. By sums where b
 * is the last one's next; else with two 64-bit divisions. Adds two spans at most. */
void etch_sector_add(struct etch_sector *s, struct etch_row *row, int32_t cx, int32_t b, int32_t x0,
                     int32_t x1);

#endif
