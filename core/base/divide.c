/* base/divide.c: 64-bit division without libgcc (whose own costs 1,090 bytes on ARMv6-M).
 * Called by set-up and projection, never by a loop over pixels. See fixed.h. */
#include "fixed.h"

struct etch_quotient etch_divide_u64(uint64_t n, uint64_t d)
{
    struct etch_quotient r = {0, n};
    uint64_t bit = 1;

    ETCH_ASSERT(d != 0 && d <= UINT64_C(1) << 63);
    while (d < n && d < UINT64_C(1) << 63) { /* align the leading ones */
        d <<= 1;
        bit <<= 1;
    }
    while (bit != 0) { /* remainder < 2d here, < d after */
        if (r.remainder >= d) {
            r.remainder -= d;
            r.quotient |= bit;
        }
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
