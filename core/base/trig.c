/* base/trig.c: integer sine. Called by matrices and by applications that animate. See trig.h. */
#include "trig.h"

/* c - x^2 * sum, one step of Horner's form: every bracket is positive and below 2. */
static uint64_t bracket(uint64_t c_q32, uint64_t sum_q32, uint32_t square_q28)
{
    return c_q32 - ((sum_q32 * square_q28) >> 28);
}

int32_t etch_sin_q30(uint16_t angle)
{
    const uint32_t folded = angle & 0x3FFF;
    const bool falling = (angle & 0x4000) != 0;
    const uint32_t x_q14 = falling ? 0x4000 - folded : folded; /* of a quarter turn */
    const uint32_t square_q28 = x_q14 * x_q14;

    /* Taylor coefficients of sin(x * pi / 2), (pi/2)^k / k! in 2^-32. The one of x^13 takes in
     * the rest of the series, so that they sum to 1 and the sine of a quarter turn is exact. */
    uint64_t sum_q32 = UINT64_C(0xF2);
    sum_q32 = bracket(UINT64_C(0x3C61), sum_q32, square_q28);
    sum_q32 = bracket(UINT64_C(0xA83C2), sum_q32, square_q28);
    sum_q32 = bracket(UINT64_C(0x132D2CD), sum_q32, square_q28);
    sum_q32 = bracket(UINT64_C(0x1466BC67), sum_q32, square_q28);
    sum_q32 = bracket(UINT64_C(0xA55DE731), sum_q32, square_q28);
    sum_q32 = bracket(UINT64_C(0x1921FB544), sum_q32, square_q28);

    const int32_t sine = (int32_t)((sum_q32 * x_q14 + 0x8000) >> 16); /* 46 to 30 bits */
    return (angle & 0x8000) != 0 ? -sine : sine;
}
