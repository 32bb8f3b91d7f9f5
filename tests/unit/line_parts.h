/* tests/unit: coordinates of lines, shared by their suites. */
#ifndef TESTS_UNIT_LINE_PARTS_H
#define TESTS_UNIT_LINE_PARTS_H

#include "tests/harness/harness.h"

/* A coordinate near the axis lo .. hi of a window, at times far from it. */
static inline int16_t pick(uint32_t *seed, int32_t lo, int32_t hi, bool far)
{
    const int32_t kind = far ? test_range(seed, 0, 4) : 4;
    const int32_t v = kind == 0   ? INT16_MIN
                      : kind == 1 ? INT16_MAX
                      : kind == 2 ? test_range(seed, INT16_MIN, INT16_MAX)
                                  : test_range(seed, lo - 20, hi + 20);

    return (int16_t)(v > INT16_MAX ? INT16_MAX : v < INT16_MIN ? INT16_MIN : v);
}

#endif
