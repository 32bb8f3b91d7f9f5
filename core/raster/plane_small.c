/* raster/plane_small.c: exact plane equations in few bytes. Called by draw/ once per varying of a
 * triangle. See plane_small.h.
 *
 * With the vertices (x_i, y_i, v_i) in 1/256 px and units, indices modulo 3,
 *
 *      D  =  sum x_i (y_i+1 - y_i+2)         |D| <= 2^48, twice the area
 *      Nx =  sum v_i (y_i+1 - y_i+2)         |N| <  2^57
 *      Ny = -sum v_i (x_i+1 - x_i+2)
 *
 * the slopes are Nx / D and Ny / D a 1/256 px, and a constant added to all v_i changes nothing.
 * Whatever is computed is whole + rest / D with whole modulo 2^32 and 0 <= rest <= D, and one
 * routine makes it: an integer times such a number, doubled and added bit by bit. A quotient
 * N / D is N times (0 + 1 / D). All is exact, so the order of the vertices cannot show. */
#include "plane_small.h"

struct number {
    uint32_t whole;
    uint64_t rest;
};

struct work {
    uint64_t d;
    struct number factor, product, sum;
};

/* product = 2^n product + bits factor, where `bits` are the upper n of a word, n = 1 .. 32; then
 * its negative if wanted. */
static void multiply(struct work *w, uint32_t bits, uint32_t n, bool negative)
{
    const uint32_t factor = w->factor.whole;
    uint32_t whole = w->product.whole;

    if (w->d < UINT32_C(1) << 30) { /* all but large triangles: below 3 D, 10 instructions a bit */
        const uint32_t d = (uint32_t)w->d, factor_rest = (uint32_t)w->factor.rest;
        uint32_t rest = (uint32_t)w->product.rest;

        do {
            whole = etch_wrap_add(whole, whole);
            rest <<= 1;
            if (bits >> 31 != 0)
                whole = etch_wrap_add(whole, factor), rest += factor_rest;
            for (; rest >= d; rest -= d)
                whole = etch_wrap_add(whole, 1);
            bits = etch_wrap_add(bits, bits);
        } while (--n != 0);
        w->product.rest = rest;
    } else {
        uint64_t rest = w->product.rest;

        do {
            whole = etch_wrap_add(whole, whole);
            rest <<= 1;
            if (bits >> 31 != 0)
                whole = etch_wrap_add(whole, factor), rest += w->factor.rest;
            for (; rest >= w->d; rest -= w->d)
                whole = etch_wrap_add(whole, 1);
            bits = etch_wrap_add(bits, bits);
        } while (--n != 0);
        w->product.rest = rest;
    }
    w->product.whole = whole;
    if (negative) { /* d / d where there was no rest */
        w->product.whole = ~whole;
        w->product.rest = w->d - w->product.rest;
    }
}

/* Begins a product with whole + rest / D. */
static void begin(struct work *w, uint32_t whole, uint64_t rest)
{
    w->factor.whole = whole;
    w->factor.rest = rest;
    w->product.whole = 0;
    w->product.rest = 0;
}

/* The slope n / d a 1/256 px: `to` times it is added to the sum, a pixel's returned, rounded. */
static uint32_t axis(struct work *w, int64_t n, int32_t to)
{
    const uint64_t magnitude = n < 0 ? (uint64_t)-n : (uint64_t)n;

    begin(w, 0, 1);
    multiply(w, (uint32_t)(magnitude >> 25), 32, false);
    multiply(w, etch_wrap_mul((uint32_t)magnitude, 128), 25, n < 0);

    const uint32_t whole = w->product.whole;
    const uint64_t rest = w->product.rest;

    begin(w, whole, rest);
    multiply(w, (uint32_t)(to < 0 ? -to : to) << 8, 24, to < 0);
    w->sum.whole = etch_wrap_add(w->sum.whole, w->product.whole);
    w->sum.rest += w->product.rest;
    for (; w->sum.rest >= w->d; w->sum.rest -= w->d)
        w->sum.whole = etch_wrap_add(w->sum.whole, 1);

    begin(w, whole, rest);
    multiply(w, UINT32_C(1) << 31, 9, false);
    return etch_wrap_add(w->product.whole, w->product.rest * 2 >= w->d);
}

/* sum (a_i + bias) (b_i+1 - b_i+2); a's elements are `step` apart, b's two. */
static ETCH_COLD int64_t cross(const int32_t *a, uint8_t step, uint32_t bias, const int32_t *b)
{
    int32_t last = b[0], next = b[2], after = b[4];
    int64_t sum = 0;

    for (uint8_t i = 3; i != 0; i--, a += step) {
        const int32_t first = last;

        sum += etch_mul_s32((int32_t)((uint32_t)*a ^ bias), next - after);
        last = next, next = after, after = first;
    }
    return sum;
}

bool etch_plane_setup_small(struct etch_plane *plane, const struct etch_point_q8 v[3],
                            const uint32_t value[3])
{
    const int64_t d = cross(&v[0].x, 2, 0, &v[0].y);
    int64_t nx = cross((const int32_t *)value, 1, UINT32_C(1) << 31, &v[0].y);
    int64_t ny = cross((const int32_t *)value, 1, UINT32_C(1) << 31, &v[0].x);
    struct work w;

    if (d == 0)
        return false;
    if (d < 0)
        nx = -nx;
    else
        ny = -ny;
    w.d = d < 0 ? (uint64_t)-d : (uint64_t)d;
    w.sum.whole = value[0];
    w.sum.rest = w.d >> 1; /* half a unit more, to round */
    plane->dx = axis(&w, nx, 128 - v[0].x);
    plane->dy = axis(&w, ny, 128 - v[0].y);
    plane->origin = w.sum.whole;
    return true;
}
