/* tests/oracle: circles by squares. See circle.h. */
#include "circle.h"

struct octant {
    int64_t a, b; /* 0 <= a <= b */
};

static struct octant fold(int32_t dx, int32_t dy)
{
    const int64_t x = dx < 0 ? -(int64_t)dx : dx, y = dy < 0 ? -(int64_t)dy : dy;
    const struct octant o = {x < y ? x : y, x < y ? y : x};

    return o;
}

/* b - 1/2 is not above sqrt(r^2 - a^2): (b - 1/2)^2 <= r^2 - a^2, or b = 0. There are no ties,
 * since the left side is an integer and a quarter. */
static bool not_above(int64_t r, int64_t a, int64_t b)
{
    return a <= r && (b == 0 || b * b - b < r * r - a * a);
}

bool oracle_circle_covers(int32_t r, int32_t dx, int32_t dy)
{
    const struct octant o = fold(dx, dy);

    return r >= 0 && not_above(r, o.a, o.b) && !not_above(r, o.a, o.b + 1);
}

bool oracle_disc_covers(int32_t r, int32_t dx, int32_t dy)
{
    const struct octant o = fold(dx, dy);

    return r >= 0 && not_above(r, o.a, o.b);
}
