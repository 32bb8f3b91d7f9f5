/* tests/oracle/polygon.h: which pixels a polygon covers, by counting crossings for each. Slow and
 * plain; nothing here is shared with core. */
#ifndef TESTS_ORACLE_POLYGON_H
#define TESTS_ORACLE_POLYGON_H

#include <stdbool.h>
#include <stdint.h>

/* An edge as the contour goes, in 1/256 px, -2^23 .. 2^23. */
struct oracle_edge {
    int32_t ax, ay, bx, by;
};

/* How many of the edges cross the ray to the left from the centre of pixel (x, y), a centre on an
 * edge being right of it, and an edge having its upper end but not its lower; *winding is those
 * that go down less those that go up. */
int32_t oracle_polygon_crossings(const struct oracle_edge *edge, int32_t n, int32_t x, int32_t y,
                                 int32_t *winding);

#endif
