/* raster/sector.h: the part of each row between two rays from a pixel; no part of the API.
 *
 * A pixel (dx, dy) off the centre is in the sector iff its direction is at or clockwise after the
 * ray `from` and before the ray `to`; the centre itself counts as the direction 0. Rays are vectors
 * of 30 bits (base/trig.h), and sides are told by the sign of a cross product: exactly.
 */
#ifndef ETCH_RASTER_SECTOR_H
#define ETCH_RASTER_SECTOR_H

#include "rows.h"

/* The line through the centre along a ray: the columns below `cut` are on one side of it. */
struct etch_sector_ray {
    int32_t dy;                  /* along it, >= 0 */
    int64_t x;                   /* row `b`: floor of b dx / dy */
    int32_t e;                   /* and remainder */
    int32_t quotient, remainder; /* of stride dx / dy: a step */
};

struct etch_sector {
    struct etch_sector_ray first, last;
    int32_t low, high; /* of row b the columns low .. high - 1 are between the rays */
    int32_t b;         /* the row, from the centre, where the rays are */
    uint8_t stride;    /* to the next */
    bool inverted; /* all but what is between the rays: the full turn too, where that is nothing */
    bool first_is_left, last_is_left; /* what is clockwise of the ray has the smaller columns */
};

/* From the angle `from` on, `sweep` 65536ths of a turn, 1 or more; 65536 or more are all. Rows and
 * columns are in any unit, within -2^25 .. 2^25. Takes four 64-bit divisions. */
void etch_sector_init(struct etch_sector *s, uint16_t from, uint32_t sweep, int32_t first,
                      uint8_t stride);

/* To the row b below the centre, which is in column cx, by sums: `first` or a multiple of `stride`
 * = 1 .. 16 below it, and not above the row before. */
void etch_sector_move(struct etch_sector *s, int32_t cx, int32_t b);

/* Adds to `row` what of x0 <= x < x1 is in the sector: two spans at most. */
void etch_sector_add(const struct etch_sector *s, struct etch_row *row, int32_t x0, int32_t x1);

#endif
