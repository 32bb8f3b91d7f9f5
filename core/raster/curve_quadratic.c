/* raster/curve_quadratic.c: quadratic curves to points. Called by applications, polygons and
 * curve_quadratic_draw.c. See curve.h.
 *
 * With n = 2^k and i = 0 .. n, n^2 p(i / n) = n^2 p0 + 2 n i (p1 - p0) + i^2 (p0 - 2 p1 + p2): its
 * first difference at 0 is 2 n (p1 - p0) + D, the second is 2 D. |n^2 p| <= 2^49. */
#include "curve_length.h"

struct axis {
    int64_t value, first, second;
};

static struct axis axis(int32_t p0, int32_t p1, int32_t p2, uint8_t k)
{
    const int64_t n = INT64_C(1) << k, bend = (int64_t)p0 - 2 * (int64_t)p1 + p2;
    const struct axis a = {n * n * p0, 2 * n * ((int64_t)p1 - p0) + bend, 2 * bend};

    return a;
}

static int32_t next(struct axis *a, uint8_t k)
{
    a->value += a->first;
    a->first += a->second;
    return curve_round(a->value, (uint8_t)(2 * k));
}

void etch_quadratic_flatten(const struct etch_point_q8 p[3], int32_t flatness_q8,
                            etch_curve_point *point, void *context)
{
    const uint8_t k = etch_curve_bits(second_difference(p[0], p[1], p[2]), flatness_q8);
    struct axis x = axis(p[0].x, p[1].x, p[2].x, k), y = axis(p[0].y, p[1].y, p[2].y, k);

    for (uint16_t i = (uint16_t)(1U << k); i != 0; i--) {
        struct etch_point_q8 to;

        to.x = next(&x, k);
        to.y = next(&y, k);
        point(context, to);
    }
}
