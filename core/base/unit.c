/* base/unit.c: vectors of length one. Called by the lights of vertex and by Phong shading in
 * fragment, once a vertex or pixel. See unit.h. */
#include "unit.h"

/* With x = s / 2^32 = 1/4 .. 1, y = 1 / sqrt(x) = 2 .. 1. The best straight line is off by 8.7 %;
 * each step y + y (1 - x y^2) / 2 takes 3/2 of the error's square: 1.2 %, 0.02 %, and 0.000005 %,
 * always from below; what is left is rounding. */
uint32_t etch_rsqrt_q31(uint32_t s)
{
    const uint32_t x_q16 = (s >> 16) + (s >> 15 & 1);
    int32_t y_q15 = (int32_t)(69878 - (x_q16 * 39895 >> 16));

    for (uint8_t i = 0; i < 3; i++) {
        const uint32_t square_q15 = (uint32_t)y_q15 * (uint32_t)y_q15 >> 15;
        /* 1 - x y^2, |.| < 0.17: x y^2 < 2^32 / 2^31 */
        const int32_t rest_q16 = ((INT32_C(1) << 30) - (int32_t)(x_q16 * square_q15 >> 1)) >> 14;

        y_q15 += y_q15 * rest_q16 >> 17; /* below 2^16 * 2^14 */
        if (y_q15 > 65535)
            y_q15 = 65535;
    }
    return (uint32_t)y_q15;
}

bool etch_unit_q14(int16_t unit[3], const int32_t v[3])
{
    /* |v| or |v| - 1: below the same power of two */
    uint32_t most = (uint32_t)((v[0] ^ v[0] >> 31) | (v[1] ^ v[1] >> 31) | (v[2] ^ v[2] >> 31));
    int32_t w[3] = {v[0], v[1], v[2]};
    uint32_t square = 0;
    uint8_t down = 0, up = 0;

    unit[0] = unit[1] = unit[2] = 0;
    if ((v[0] | v[1] | v[2]) == 0)
        return false;
    for (; most >> down >= UINT32_C(1) << 15; down++)
        ;
    for (; most < UINT32_C(1) << 14 && down == 0; most = most * 2 + 1)
        up++;
    for (uint8_t i = 0; i < 3; i++) { /* to 2^14 .. 2^15 */
        w[i] = (w[i] >> down) * (INT32_C(1) << up);
        square += (uint32_t)(w[i] * w[i]); /* 2^28 .. 3 * 2^30 */
    }
    for (up = 0; square < UINT32_C(1) << 30; square *= 4)
        up++;

    const int32_t reciprocal = (int32_t)etch_rsqrt_q31(square); /* 2^(31 - up) / length */

    for (uint8_t i = 0; i < 3; i++) /* w r below 2^31: |w| r 2^up <= 2^31 sqrt(s) / sqrt(s) */
        unit[i] = (int16_t)((w[i] * reciprocal + (INT32_C(1) << (16 - up))) >> (17 - up));
    return true;
}
