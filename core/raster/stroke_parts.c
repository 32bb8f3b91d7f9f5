/* raster/stroke_parts.c: the rectangles of strokes. Called by stroke.c and its caps and joints. See
 * stroke.h. */
#include "stroke_parts.h"

/* floor(sqrt(v)), v < 2^62, one bit a step. */
static uint32_t root(uint64_t v)
{
    uint64_t result = 0;

    for (uint64_t bit = UINT64_C(1) << 60; bit != 0; bit >>= 2) {
        const uint64_t least = result + bit;

        result >>= 1;
        if (v >= least) {
            v -= least;
            result += bit;
        }
    }
    return (uint32_t)result;
}

static uint64_t square(int32_t x, int32_t y)
{
    return (uint64_t)(etch_mul_s32(x, x) + etch_mul_s32(y, y));
}

uint32_t etch_stroke_length(int32_t x, int32_t y)
{
    return root(square(x, y));
}

/* v size / (length / 2^shift), |v| 2^shift <= 2^25, size <= 2^24. */
static int32_t share(int32_t v, int32_t size, uint32_t length, uint8_t shift)
{
    const int64_t n = etch_mul_s32(v < 0 ? -v : v, size);
    const struct etch_quotient whole = etch_divide_u64((uint64_t)n << shift, length);
    const int32_t q = (int32_t)(whole.quotient + (whole.remainder >= length - whole.remainder));

    return v < 0 ? -q : q;
}

struct etch_point_q8 etch_stroke_scaled(int32_t x, int32_t y, int32_t size)
{
    struct etch_point_q8 p = {0, 0};
    uint64_t s = square(x, y); /* 1 .. 2^51 */
    uint8_t shift = 0;

    if (s == 0)
        return p;
    for (; s < UINT64_C(1) << 48; s <<= 2)
        shift++;
    const uint32_t length = root(s);

    p.x = share(x, size, length, shift);
    p.y = share(y, size, length, shift);
    return p;
}

void etch_stroke_convex(const struct etch_outline *o, const struct etch_point_q8 *v, uint8_t n)
{
    int64_t area = 0;

    for (uint8_t i = 2; i < n; i++)
        area += etch_mul_s32(v[i - 1].x - v[0].x, v[i].y - v[0].y) -
                etch_mul_s32(v[i].x - v[0].x, v[i - 1].y - v[0].y);
    for (uint8_t i = 0; i < n; i++) {
        const struct etch_point_q8 a = v[i], b = v[i + 1 == n ? 0 : i + 1];

        o->edge(o->shape, area < 0 ? b : a, area < 0 ? a : b);
    }
}

void etch_stroke_segment(const struct etch_outline *o, struct etch_point_q8 a,
                         struct etch_point_q8 b, struct etch_point_q8 n)
{
    const struct etch_point_q8 v[4] = {stroke_moved(a, n.x, n.y), stroke_moved(b, n.x, n.y),
                                       stroke_moved(b, -n.x, -n.y), stroke_moved(a, -n.x, -n.y)};

    etch_stroke_convex(o, v, 4);
}
