/* raster/curve_cubic.c: cubic curves to points. Called by applications, polygons and
 * curve_cubic_draw.c. See curve.h.
 *
 * With n = 2^k, A = p3 - 3 p2 + 3 p1 - p0, B = 3 (p0 - 2 p1 + p2), C = 3 (p1 - p0) and i = 0 .. n,
 *
 *      n^3 p(i / n) = A i^3 + B n i^2 + C n^2 i + p0 n^3
 *
 * whose differences at 0 are A + B n + C n^2, 6 A + 2 B n and 6 A. On the curve |n^3 p| <= 2^23
 * 2^39: it is a mean of the control points. One step of it is at most 3 2^24 n^2 < 2^52. */
#include "curve_length.h"

struct axis {
    int64_t value, first, second, third;
};

static struct axis axis(int32_t p0, int32_t p1, int32_t p2, int32_t p3, uint8_t k)
{
    const int64_t n = INT64_C(1) << k;
    const int64_t a = (int64_t)p3 - p0 + 3 * ((int64_t)p1 - p2);
    const int64_t b = 3 * ((int64_t)p0 - 2 * (int64_t)p1 + p2), c = 3 * ((int64_t)p1 - p0);
    const struct axis start = {n * n * n * p0, a + b * n + c * n * n, 6 * a + 2 * b * n, 6 * a};

    return start;
}

static int32_t next(struct axis *a, uint8_t k)
{
    a->value += a->first;
    a->first += a->second;
    a->second += a->third;
    return curve_round(a->value, (uint8_t)(3 * k));
}

void etch_cubic_flatten(const struct etch_point_q8 p[4], int32_t flatness_q8,
                        etch_curve_point *point, void *context)
{
    const uint32_t d0 = second_difference(p[0], p[1], p[2]);
    const uint32_t d1 = second_difference(p[1], p[2], p[3]);
    const uint8_t k = etch_curve_bits(3 * (d0 > d1 ? d0 : d1), flatness_q8);
    struct axis x = axis(p[0].x, p[1].x, p[2].x, p[3].x, k);
    struct axis y = axis(p[0].y, p[1].y, p[2].y, p[3].y, k);

    for (uint16_t i = (uint16_t)(1U << k); i != 0; i--) {
        struct etch_point_q8 to;

        to.x = next(&x, k);
        to.y = next(&y, k);
        point(context, to);
    }
}
