/* vertex/project.c: the perspective division. Called by the mesh's vertex loop and by assembly,
 * once a vertex. See viewport.h.
 *
 * One reciprocal serves the three quotients. It is a little too small, so each quotient is at
 * most one too small, and its remainder, exact in modular 32-bit arithmetic, says which. From
 * w = 16384.0 on remainders do not fit and the 64-bit divide does the same. */
#include "reciprocal.h"
#include "viewport.h"

/* ---- one reciprocal -------------------------------------------------------------------------- */

struct divisor {
    uint32_t w;          /* 1 .. 2^30 - 1 */
    uint32_t reciprocal; /* 2^63 / (w << shift), at most 2^-26 of it too small */
    uint8_t shift;       /* w << shift is in 2^31 .. 2^32 - 1 */
};

/* A first guess r = 2^48 / W from W's upper half, 17 bits, too small by e < 1.5 * 2^-15 of it,
 * then one step of Newton's iteration, r (1 + e). What is left: e^2 < 2^-28, 2^-27 for taking W
 * in 28 bits, and 2^-29 for taking e in 15. */
static struct divisor divisor(uint32_t w)
{
    struct divisor d = {w, 0, etch_leading_zeros(w)};
    const uint32_t top = w << d.shift;
    const uint32_t guess = etch_reciprocal((top >> 16) + 1);
    /* 2^44 e = 2^44 - guess W / 16, which is below 2^30, so modulo 2^32 will do */
    const uint32_t error = etch_wrap_sub(0, etch_wrap_mul(guess, (top >> 4) + 1));

    d.reciprocal = (guess << 15) + (guess * (error >> 15) >> 14);
    return d;
}

/* a * b / 2^32, at most 2 too small. */
static uint32_t mul_high(uint32_t a, uint32_t b)
{
    const uint32_t a0 = a & 0xFFFF, a1 = a >> 16, b0 = b & 0xFFFF, b1 = b >> 16;

    return a1 * b1 + (a1 * b0 >> 16) + (a0 * b1 >> 16);
}

/* v / w in 1.31 for v <= w, at most 28 units too small. */
static uint32_t ratio_q31(const struct divisor *d, uint32_t v)
{
    return mul_high(v << d->shift, d->reciprocal);
}

/* ---- positions ------------------------------------------------------------------------------- */

/* 128 size v / w rounded half up (`up`: v is positive) or half down, v <= 2^31, size <= 65535. */
static uint32_t scale(const struct divisor *d, uint32_t size, uint32_t v, bool up)
{
    const uint32_t w = d->w;
    const uint32_t whole = v > w ? v / w : 0; /* off-screen; at most the guard's 2^10 */

    v -= whole * w;
    const uint32_t ratio = ratio_q31(d, v);
    /* size * 28 / 2^24 + 2^-8 < 1: at most one too small */
    uint32_t quotient = (size * (ratio >> 16) + (size * (ratio & 0xFFFF) >> 16)) >> 8;
    uint32_t rest = etch_wrap_sub(etch_wrap_mul(size * 128, v), etch_wrap_mul(quotient, w));

    if (rest >= w) {
        rest -= w;
        quotient++;
    }
    if (rest * 2 > w || (rest * 2 == w && up))
        quotient++;
    return size * 128 * whole + quotient;
}

static int32_t place(const struct divisor *d, int32_t size, etch_q16 v)
{
    return v < 0 ? -(int32_t)scale(d, (uint32_t)size, etch_wrap_sub(0, (uint32_t)v), false)
                 : (int32_t)scale(d, (uint32_t)size, (uint32_t)v, true);
}

/* The negative of place(): y turns round, and a half goes up after that. */
static int32_t place_turned(const struct divisor *d, int32_t size, etch_q16 v)
{
    return v < 0 ? (int32_t)scale(d, (uint32_t)size, etch_wrap_sub(0, (uint32_t)v), true)
                 : -(int32_t)scale(d, (uint32_t)size, (uint32_t)v, false);
}

/* ---- depth ----------------------------------------------------------------------------------- */

/* v / 2w of 65535 in 16.16, v = z + w = 0 .. 2w: the whole part, then 16 bits of fraction. */
static uint32_t depth(const struct divisor *d, uint32_t v)
{
    const uint32_t whole_w = d->w * 2; /* remainders are below 2 of it */
    const uint32_t ratio = mul_high(v << (d->shift - 1), d->reciprocal);
    uint32_t high = (ratio - ((ratio + 65535) >> 16)) >> 15; /* 65535 / 65536 of it */
    uint32_t rest = etch_wrap_sub(etch_wrap_mul(v, 65535), etch_wrap_mul(high, whole_w));

    if (rest >= whole_w) {
        rest -= whole_w;
        high++;
    }
    uint32_t low = mul_high(rest << (d->shift - 1), d->reciprocal) >> 15;

    rest = etch_wrap_sub(etch_wrap_mul(rest, 65536), etch_wrap_mul(low, whole_w));
    if (rest >= whole_w) {
        rest -= whole_w;
        low++;
    }
    return high * 65536 + low + (rest >= d->w ? 1 : 0);
}

/* ---- w of 16384.0 and more ------------------------------------------------------------------- */

/* Products below 2^16 * 2^31 * 2^7. */
static int32_t place_wide(int32_t size, etch_q16 v, etch_q16 w)
{
    return etch_divide_round_s64((int64_t)(size * 128) * v, w);
}

/* At most (2^32 - 2) * (2^32 - 2^16) + 2^31 < 2^64. */
static uint32_t depth_wide(uint32_t v, etch_q16 w)
{
    const uint64_t n = (uint64_t)v * UINT32_C(0xFFFF0000) + (uint32_t)w;

    return (uint32_t)etch_divide_u64(n, (uint64_t)w * 2).quotient;
}

static ETCH_COLD void project_wide(const struct etch_rect *r, const struct etch_clip_vertex *in,
                                   uint32_t v, struct etch_vertex *out)
{
    out->x_q8 = place_wide((int32_t)r->x1 - r->x0, in->x, in->w);
    out->y_q8 = place_wide(-((int32_t)r->y1 - r->y0), in->y, in->w);
    out->z_q16 = depth_wide(v, in->w);
}

void etch_viewport_project(const struct etch_viewport *v, const struct etch_clip_vertex *in,
                           struct etch_vertex *out)
{
    const struct etch_rect *r = &v->rect;
    /* z + w, and within 0 .. 2w also where a clipped corner's z was rounded beyond it */
    const uint32_t above = in->z >= in->w    ? (uint32_t)in->w * 2
                           : in->z <= -in->w ? 0
                                             : etch_wrap_add((uint32_t)in->z, (uint32_t)in->w);

    if (in->w < INT32_C(1) << 30) {
        const struct divisor d = divisor((uint32_t)in->w);

        out->x_q8 = place(&d, (int32_t)r->x1 - r->x0, in->x);
        out->y_q8 = place_turned(&d, (int32_t)r->y1 - r->y0, in->y);
        out->z_q16 = depth(&d, above);
    } else {
        project_wide(r, in, above, out);
    }
    out->x_q8 += ((int32_t)r->x0 + r->x1) * 128;
    out->y_q8 += ((int32_t)r->y0 + r->y1) * 128;
    out->r = in->r;
    out->g = in->g;
    out->b = in->b;
    out->a = in->a;
}
