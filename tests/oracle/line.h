/* tests/oracle/line.h: lines by their definition. */
#ifndef TESTS_ORACLE_LINE_H
#define TESTS_ORACLE_LINE_H

#include <stdbool.h>
#include <stdint.h>

/* True iff (x, y) is a pixel of the line from (x0, y0) to (x1, y1): on the minor axis nearest to
 * the true line; on a tie on the side of the end with the smaller major coordinate. */
bool oracle_line_covers(int32_t x0, int32_t y0, int32_t x1, int32_t y1, int32_t x, int32_t y);

#endif
