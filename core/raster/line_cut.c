/* raster/line_cut.c: where a line meets a side of a rectangle. Called by the clippers of lines and
 * polygons. See line_cut.h.
 *
 * With u the axis and v the other one, at u = at
 *
 *      v - bound = ((a_v - bound) (b_u - at) + (b_v - bound) (at - a_u)) / (b_u - a_u)
 *
 * Where the two terms have different signs their magnitudes are compared, below 2^64. */
#include "line_cut.h"

static int8_t sign(int32_t v, int32_t bound)
{
    return (int8_t)((v > bound) - (v < bound));
}

int8_t etch_line_cut_compare(const int32_t a[2], const int32_t b[2], uint8_t axis, int32_t at,
                             int32_t bound)
{
    const uint8_t v = axis ^ 1;
    const uint64_t of_a = (uint64_t)etch_line_cut_distance(a[v], bound) *
                          etch_line_cut_distance(b[axis], at);
    const uint64_t of_b = (uint64_t)etch_line_cut_distance(b[v], bound) *
                          etch_line_cut_distance(a[axis], at);
    const int8_t sign_a = sign(a[v], bound), sign_b = sign(b[v], bound);

    if (of_a == of_b)
        return sign_a == sign_b && of_a != 0 ? sign_a : 0;
    return of_a > of_b ? sign_a : sign_b;
}

int32_t etch_line_cut_round(const int32_t a[2], const int32_t b[2], uint8_t axis, int32_t at)
{
    const uint8_t v = axis ^ 1;
    const uint32_t width = etch_line_cut_distance(a[axis], b[axis]);
    const uint64_t n = (uint64_t)etch_line_cut_distance(a[v], b[v]) *
                       etch_line_cut_distance(a[axis], at);
    const struct etch_quotient q = etch_divide_u64(n, width);
    const bool falls = b[v] < a[v];
    const uint64_t rest = width - q.remainder;
    const int64_t steps = (int64_t)q.quotient +
                          (q.remainder > rest || (q.remainder == rest && !falls) ? 1 : 0);

    return (int32_t)(falls ? a[v] - steps : a[v] + steps);
}
