/* draw/line_wide_corners.c: the rectangle of a line with a width. Called by line_wide.c and
 * line_wide_staged.c. See line.h. */
#include "line.h"

/* floor(sqrt(v)) for v < 2^62, one bit a step. */
static uint32_t root(uint64_t v)
{
    uint64_t bit = UINT64_C(1) << 60, result = 0;

    for (; bit != 0; bit >>= 2) {
        const bool fits = v >= result + bit;

        v -= fits ? result + bit : 0;
        result = (result >> 1) + (fits ? bit : 0);
    }
    return (uint32_t)result;
}

/* width * d / length, rounded, for |d| <= 2^24. The length is that of (dx, dy) times 2^shift, 2^29
 * to 2^30, so to take it whole errs by 2^-29 of the quotient, which is below 2^16. */
static int32_t across(int32_t d, uint16_t width, uint32_t length, uint8_t shift)
{
    const uint64_t n = ((uint64_t)(d < 0 ? -d : d) << shift) * width + length / 2;
    const int32_t q = (int32_t)etch_divide_u64(n, length).quotient;

    return d < 0 ? -q : q;
}

/* The way across: the normal (-dy, dx) at the length of the width, turned so that x + y grows. */
static void normal(int32_t n[2], int32_t dx, int32_t dy, uint16_t width)
{
    uint64_t square = (uint64_t)(etch_mul_s32(dx, dx) + etch_mul_s32(dy, dy)); /* 1 .. 2^49 */
    uint8_t shift = 0;

    for (; square < UINT64_C(1) << 58; square <<= 2)
        shift++;
    const uint32_t length = root(square);
    const int32_t x = across(-dy, width, length, shift), y = across(dx, width, length, shift);
    const bool turn = x + y < 0 || (x + y == 0 && x < 0);

    n[0] = turn ? -x : x;
    n[1] = turn ? -y : y;
}

static int32_t held(int32_t q8)
{
    const int32_t most = INT32_C(1) << 23;

    return q8 < -most ? -most : q8 > most ? most : q8;
}

/* v moved by the nearer half of n, or by the other one with the odd unit. */
static struct etch_vertex corner(const struct etch_vertex *v, const int32_t n[2], bool far)
{
    struct etch_vertex c = *v;

    c.x_q8 = held(v->x_q8 - (n[0] >> 1) + (far ? n[0] : 0));
    c.y_q8 = held(v->y_q8 - (n[1] >> 1) + (far ? n[1] : 0));
    return c;
}

bool etch_line_wide_corners(struct etch_vertex out[4], const struct etch_vertex *const v[2],
                            uint16_t width_q8)
{
    const int32_t dx = v[1]->x_q8 - v[0]->x_q8, dy = v[1]->y_q8 - v[0]->y_q8;
    int32_t n[2];

    if (width_q8 == 0 || (dx == 0 && dy == 0))
        return false;
    normal(n, dx, dy, width_q8);
    out[0] = corner(v[0], n, false), out[1] = corner(v[1], n, false);
    out[2] = corner(v[1], n, true), out[3] = corner(v[0], n, true);
    return true;
}
