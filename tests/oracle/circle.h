/* tests/oracle/circle.h: the midpoint circle and its disc, by definition, pixel by pixel. */
#ifndef TESTS_ORACLE_CIRCLE_H
#define TESTS_ORACLE_CIRCLE_H

#include <stdbool.h>
#include <stdint.h>

/* True iff the pixel (dx, dy) from the centre is on the outline of radius r: folded into the
 * octant 0 <= a <= b, b is the integer nearest to sqrt(r^2 - a^2). */
bool oracle_circle_covers(int32_t r, int32_t dx, int32_t dy);

/* True iff it is on or inside that outline: folded likewise, b is at most that integer. */
bool oracle_disc_covers(int32_t r, int32_t dx, int32_t dy);

#endif
