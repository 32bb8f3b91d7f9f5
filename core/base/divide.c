/* base/divide.c: 64-bit division without libgcc (whose own costs 1,090 bytes on ARMv6-M).
 * Called by set-up and projection, never by a loop over pixels. See fixed.h. */
#include "fixed.h"

/* A power of two, for the proof: `bit` halves without a rest until it is 1. */
/*@ predicate is_power(integer n) = n == 1 || (n == 2 * (n >> 1) && n > 1 && is_power(n >> 1)); */

struct etch_quotient etch_divide_u64(uint64_t n, uint64_t d)
{
    struct etch_quotient r = {0, n};
    uint64_t bit = 1;

    ETCH_ASSERT(d != 0 && d <= UINT64_C(1) << 63);
    /*@ loop invariant d == \at(d, Pre) * bit && 1 <= bit <= d && is_power(bit);
        loop assigns d, bit;
        loop variant 0x10000000000000000 - d; */
    while (d < n && d < UINT64_C(1) << 63) { /* align the leading ones */
        d <<= 1;
        bit <<= 1;
        /*@ assert bit >> 1 == \at(bit, LoopCurrent); */
    }
    /*@ loop invariant n == r.quotient * \at(d, Pre) + r.remainder;
        loop invariant bit != 0 ==> is_power(bit);
        loop invariant bit != 0 ==> d == \at(d, Pre) * bit;
        loop invariant bit != 0 ==> r.remainder < 2 * d;
        loop invariant bit == 0 ==> r.remainder < \at(d, Pre);
        loop assigns r, d, bit;
        loop variant bit; */
    while (bit != 0) { /* remainder < 2d here, < d after */
        /*@ assert bit == 1 ==> bit >> 1 == 0 && d == \at(d, Pre); */
        /*@ assert bit > 1 ==> d == 2 * (\at(d, Pre) * (bit >> 1)); */
        /*@ assert bit > 1 ==> d == 2 * (d >> 1); */
        if (r.remainder >= d) {
            /*@ assert (r.quotient + bit) * \at(d, Pre) <= n; */
            r.remainder -= d;
            r.quotient += bit;
        }
        /*@ assert r.remainder < d; */
        /*@ assert bit >> 1 == 0 ==> r.remainder < \at(d, Pre); */
        d >>= 1;
        bit >>= 1;
    }
    return r;
}

int32_t etch_divide_round_s64(int64_t n, int64_t d)
{
    const bool negative = (n < 0) != (d < 0);
    const uint64_t divisor = d < 0 ? (uint64_t)-d : (uint64_t)d;
    const struct etch_quotient r = etch_divide_u64(n < 0 ? (uint64_t)-n : (uint64_t)n, divisor);
    const uint64_t rest = divisor - r.remainder; /* up to the next larger magnitude */
    uint64_t magnitude = r.quotient;

    /* Half up: a tie goes to the larger value, away from zero only if positive. */
    if (r.remainder > rest || (r.remainder == rest && !negative))
        magnitude++;
    if (negative)
        return magnitude >= UINT64_C(0x80000000) ? INT32_MIN : -(int32_t)magnitude;
    return magnitude > INT32_MAX ? INT32_MAX : (int32_t)magnitude;
}

etch_q16 etch_q16_div(etch_q16 a, etch_q16 b)
{
    if (b == 0)
        return a > 0 ? INT32_MAX : a < 0 ? INT32_MIN : 0;
    return etch_divide_round_s64((int64_t)a * 65536, b);
}
