/* tests/oracle: lines, one rounded division a pixel. See line.h. */
#include "line.h"

/* For a line whose major axis is `a`: the pixel of column a, or false. The exact minor coordinate
 * is b0 + (a - a0) (b1 - b0) / (a1 - a0); a tie stays with b0. */
static bool covers(int32_t a0, int32_t b0, int32_t a1, int32_t b1, int32_t a, int32_t b)
{
    const int64_t da = (int64_t)a1 - a0;
    const int64_t db = (int64_t)b1 - b0;
    int64_t steps;

    if (da < 0)
        return covers(a1, b1, a0, b0, a, b);
    if (a < a0 || a > a1)
        return false;
    if (da == 0)
        return b == b0;
    /* n = |db| (a - a0) / da rounded, half down: the least n with 2 |db| (a - a0) <= (2n + 1) da */
    steps = db < 0 ? b0 - (int64_t)b : b - (int64_t)b0;
    if (steps < 0)
        return false;
    return 2 * (db < 0 ? -db : db) * (a - a0) <= (2 * steps + 1) * da &&
           2 * (db < 0 ? -db : db) * (a - a0) > (2 * steps - 1) * da;
}

bool oracle_line_covers(int32_t x0, int32_t y0, int32_t x1, int32_t y1, int32_t x, int32_t y)
{
    const int32_t dx = x1 > x0 ? x1 - x0 : x0 - x1;
    const int32_t dy = y1 > y0 ? y1 - y0 : y0 - y1;

    return dx >= dy ? covers(x0, y0, x1, y1, x, y) : covers(y0, x0, y1, x1, y, x);
}
