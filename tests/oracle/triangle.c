/* tests/oracle: triangles by edge functions over every pixel. See triangle.h. */
#include "triangle.h"

/* Which side of the line a -> b the point p is on: positive to the right as seen, y down.
 * Differences stay below 2^25, so the products stay below 2^50. */
static int64_t side(int32_t ax, int32_t ay, int32_t bx, int32_t by, int32_t px, int32_t py)
{
    return (int64_t)(bx - ax) * (py - ay) - (int64_t)(by - ay) * (px - ax);
}

void oracle_triangle_make(struct oracle_triangle *t, const int32_t x[3], const int32_t y[3])
{
    const int64_t area = side(x[0], y[0], x[1], y[1], x[2], y[2]);
    const bool clockwise = area >= 0;
    int i;

    for (i = 0; i < 3; i++) {
        t->from[i] = (uint8_t)(clockwise ? i : 2 - i);
        t->x[i] = x[t->from[i]];
        t->y[i] = y[t->from[i]];
    }
    t->area = clockwise ? area : -area;
}

int64_t oracle_triangle_edge(const struct oracle_triangle *t, int i, int32_t x, int32_t y)
{
    const int a = (i + 1) % 3, b = (i + 2) % 3;

    return side(t->x[a], t->y[a], t->x[b], t->y[b], 256 * x + 128, 256 * y + 128);
}

/* In a clockwise triangle a left edge goes up, and a top edge goes straight to the right. */
static bool is_top_or_left(const struct oracle_triangle *t, int i)
{
    const int a = (i + 1) % 3, b = (i + 2) % 3;

    return t->y[b] < t->y[a] || (t->y[b] == t->y[a] && t->x[b] > t->x[a]);
}

bool oracle_triangle_covers(const struct oracle_triangle *t, int32_t x, int32_t y)
{
    int i;

    if (t->area == 0)
        return false;
    for (i = 0; i < 3; i++) {
        const int64_t e = oracle_triangle_edge(t, i, x, y);

        if (e < 0 || (e == 0 && !is_top_or_left(t, i)))
            return false;
    }
    return true;
}

/* Each edge function is the weight of the vertex opposite to it, times the area. */
struct wide oracle_triangle_value(const struct oracle_triangle *t, int32_t x, int32_t y,
                                  const uint32_t value[3])
{
    struct wide sum = {0, 0};
    int i;

    for (i = 0; i < 3; i++) {
        const int64_t weight = oracle_triangle_edge(t, i, x, y);

        sum = wide_sum(sum, wide_product((uint64_t)weight, value[t->from[i]]));
    }
    return sum;
}
