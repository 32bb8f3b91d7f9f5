/* tests/oracle/triangle.h: which pixels a triangle covers, by its definition, and the exact
 * value of a varying there. Slow and plain; nothing here is shared with core. */
#ifndef TESTS_ORACLE_TRIANGLE_H
#define TESTS_ORACLE_TRIANGLE_H

#include <stdbool.h>
#include <stdint.h>

#include "wide.h"

/* Vertices in 1/256 px, -2^23 .. 2^23, turned so that they run clockwise as seen (y down). */
struct oracle_triangle {
    int32_t x[3], y[3];
    uint8_t from[3]; /* vertex i here is vertex from[i] of the caller */
    int64_t area;    /* twice the area, 0 .. 2^48 */
};

void oracle_triangle_make(struct oracle_triangle *t, const int32_t x[3], const int32_t y[3]);

/* The edge function of the side opposite to vertex i (of `t`) at the centre of pixel (x, y),
 * which is `area` times that vertex's barycentric weight; |e| < 2^50. */
int64_t oracle_triangle_edge(const struct oracle_triangle *t, int i, int32_t x, int32_t y);

/* True iff the centre of pixel (x, y) is inside the triangle or on a top or left edge. */
bool oracle_triangle_covers(const struct oracle_triangle *t, int32_t x, int32_t y);

/* Interpolation: `area` times the exact value at the centre of a covered pixel, of a varying that
 * is value[i] at the caller's vertex i. */
struct wide oracle_triangle_value(const struct oracle_triangle *t, int32_t x, int32_t y,
                                  const uint32_t value[3]);

#endif
