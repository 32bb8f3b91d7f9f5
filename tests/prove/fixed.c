/* proved: products, leading zeros, saturation, snapping of base/fixed.h stay in their types
 *          for every argument, and the results in the ranges that the header states
 * assumed: nothing */
#include "prove.h"
#include "core/base/fixed.h"

void prove(void)
{
    const int32_t a = ANY_S32, b = (int32_t)any(0, INT32_MAX);
    int32_t r;

    (void)etch_mul_s16(ANY_S16, ANY_S16);
    (void)etch_mul_u16((uint16_t)any(0, 65535), (uint16_t)any(0, 65535));
    (void)etch_mul_s32(a, ANY_S32);
    (void)etch_mul_high_wide(a, b);
    (void)etch_mul_high_split(a, b);
    for (int n = 0; n < 32; n++) { /* the numbers whose highest bit is n */
        r = etch_leading_zeros((uint32_t)any(1LL << n, (2LL << n) - 1));
        /*@ check r == 31 - n; */
    }
    r = etch_leading_zeros(0);
    /*@ check r == 32; */
    (void)etch_saturate_s32(any(INT64_MIN, INT64_MAX));
    (void)etch_q16_mul(a, ANY_S32);
    r = etch_snap_q8(a);
    /*@ check -8388608 <= r <= 8388608; */
}
