/* raster/plane.c: exact plane equations, the second part of triangle set-up. Called by draw/
 * once per varying of a visible triangle. See plane.h.
 *
 * With vertex differences (x_i, y_i, v_i) against p[0] in 1/256 px and units, i = 1, 2:
 *
 *      D  = x1 y2 - x2 y1            |D|  <= 2^48, the doubled area
 *      Nx = v1 y2 - v2 y1            |Nx| <= (2^32 - 1) 2^24 < 2^56
 *      Ny = v2 x1 - v1 x2            likewise
 *
 * the slopes are Nx / D and Ny / D units per 1/256 px. Everything a kernel computes is modulo
 * 2^32, so of each quotient only the lower 32 bits matter: Nx = q D + r with 0 <= r < D keeps
 * q whole and r exact, and what follows needs no wider number.
 */
#include "plane.h"

/* A slope per 1/256 px as whole + rest / D. */
struct slope {
    uint32_t whole; /* modulo 2^32 */
    uint64_t rest;  /* 0 .. D - 1 */
};

/*@ requires 1 <= d <= 0x1000000000000;
    requires -0x200000000000000 < n < 0x200000000000000;
    assigns \nothing;
    ensures \result.rest < d; */
static struct slope slope_of(int64_t n, uint64_t d)
{
    const struct etch_quotient q = etch_divide_u64(n < 0 ? (uint64_t)-n : (uint64_t)n, d);
    struct slope s = {(uint32_t)(q.quotient & UINT32_MAX), q.remainder};

    if (n < 0) { /* floor, not truncation */
        s.whole = etch_wrap_sub(0, s.whole);
        if (s.rest != 0) {
            s.whole = etch_wrap_sub(s.whole, 1);
            s.rest = d - s.rest;
        }
    }
    return s;
}

/* k * s.rest / d as whole + rest / d, for k < 2^24, bit by bit from the top: rest < D before a
 * step, at most 3 D - 2 < 2^50 in it, below D again after. */
/*@ requires 1 <= d <= 0x1000000000000;
    requires s.rest < d;
    assigns \nothing;
    ensures \result.rest < d; */
static struct slope times_rest(struct slope s, uint32_t k, uint64_t d)
{
    struct slope t = {0, 0};

    /*@ loop invariant t.rest < d;
        loop assigns t, bit; */
    for (uint32_t bit = UINT32_C(1) << 23; bit != 0; bit >>= 1) {
        t.whole = etch_wrap_add(t.whole, t.whole);
        t.rest = 2 * t.rest + ((k & bit) != 0 ? s.rest : 0);
        /*@ loop invariant t.rest < 3 * d;
            loop assigns t; */
        while (t.rest >= d) {
            t.rest -= d;
            t.whole = etch_wrap_add(t.whole, 1);
        }
    }
    return t;
}

/* k * s as whole + rest / d; |k| <= 2^24. */
/*@ requires 1 <= d <= 0x1000000000000;
    requires s.rest < d;
    requires -0x1000000 <= k <= 0x1000000;
    assigns \nothing;
    ensures \result.rest < d; */
static struct slope times(struct slope s, int32_t k, uint64_t d)
{
    struct slope t = times_rest(s, (uint32_t)(k < 0 ? -k : k), d);

    if (k < 0) {
        t.whole = etch_wrap_sub(0, t.whole);
        if (t.rest != 0) {
            t.whole = etch_wrap_sub(t.whole, 1);
            t.rest = d - t.rest;
        }
    }
    t.whole = etch_wrap_add(t.whole, etch_wrap_mul(s.whole, (uint32_t)k));
    return t;
}

/*@ requires s.rest < d;
    assigns \nothing; */
static uint32_t rounded(struct slope s, uint64_t d)
{
    return etch_wrap_add(s.whole, s.rest >= d - s.rest ? 1 : 0);
}

void etch_plane_setup(struct etch_plane *plane, const struct etch_triangle *t,
                      const uint32_t value[3])
{
    const uint32_t v0 = value[t->order[0]];
    const int64_t v1 = (int64_t)value[t->order[1]] - v0;
    const int64_t v2 = (int64_t)value[t->order[2]] - v0;

    plane->origin = v0;
    plane->dx = 0;
    plane->dy = 0;
    if (v1 == 0 && v2 == 0) /* a constant costs nothing and is exact */
        return;

    const int32_t x1 = t->p[1].x - t->p[0].x, y1 = t->p[1].y - t->p[0].y;
    const int32_t x2 = t->p[2].x - t->p[0].x, y2 = t->p[2].y - t->p[0].y;
    const uint64_t d = t->area;
    const struct slope sx = slope_of(t->side * (v1 * y2 - v2 * y1), d);
    const struct slope sy = slope_of(t->side * (v2 * x1 - v1 * x2), d);
    struct slope ox = times(sx, 128 - t->p[0].x, d); /* from p[0] to the centre of (0, 0) */
    const struct slope oy = times(sy, 128 - t->p[0].y, d);

    plane->dx = rounded(times(sx, 256, d), d);
    plane->dy = rounded(times(sy, 256, d), d);
    ox.whole = etch_wrap_add(ox.whole, oy.whole);
    ox.rest += oy.rest;
    if (ox.rest >= d) {
        ox.rest -= d;
        ox.whole = etch_wrap_add(ox.whole, 1);
    }
    plane->origin = etch_wrap_add(v0, rounded(ox, d));
}
