/* vertex/lamp_sum.h: what the shade functions of lamp.h share; no part of the API. */
#ifndef ETCH_VERTEX_LAMP_SUM_H
#define ETCH_VERTEX_LAMP_SUM_H

#include "../base/unit.h"
#include "lamp.h"

/* Light of each channel in 8.12, 255 is all of it. */
struct lamp_sum {
    uint32_t diffuse_q12[3], specular_q12[3];
};

/* q16 intensity times a factor in 4.28, 0 .. 1.1: 4.12, at most 4.4. */
ETCH_INLINE uint32_t lamp_weight_q12(uint32_t intensity_q16, int32_t factor_q28)
{
    return ((intensity_q16 >> 2) * (uint32_t)(factor_q28 >> 14) + (UINT32_C(1) << 15)) >> 16;
}

ETCH_INLINE void lamp_add(uint32_t sum_q12[3], const uint8_t color[3], uint32_t weight_q12)
{
    for (int k = 0; k < 3; k++)
        sum_q12[k] += color[k] * weight_q12; /* 255 lamps: below 2^31 */
}

/* Half the way from a position to a place, both 16.16, rounded down: it fits. */
ETCH_INLINE void lamp_away(int32_t away[3], const struct etch_vector *place,
                           const etch_q16 position[3])
{
    away[0] = (int32_t)(((int64_t)place->x - position[0]) >> 1);
    away[1] = (int32_t)(((int64_t)place->y - position[1]) >> 1);
    away[2] = (int32_t)(((int64_t)place->z - position[2]) >> 1);
}

/* V. */
ETCH_INLINE void lamp_view(int16_t view[3], const struct etch_lamps *lamps,
                           const struct etch_shade_point *point)
{
    int32_t away[3];

    if (lamps->eye_is_far) {
        view[0] = (int16_t)lamps->eye.x;
        view[1] = (int16_t)lamps->eye.y;
        view[2] = (int16_t)lamps->eye.z;
    } else {
        lamp_away(away, &lamps->eye, point->position);
        (void)etch_unit_q14(view, away);
    }
}

/* x^n in 4.28 for x = 0 .. 1.1 in 2.29, at most 1: by squares, each within 4 units of 2^-30. */
ETCH_INLINE int32_t lamp_power_q28(int32_t x_q29, uint8_t n)
{
    int32_t power = INT32_C(1) << 30;
    int32_t x = x_q29 < INT32_C(1) << 29 ? x_q29 * 2 : power;

    for (; n != 0; n >>= 1) {
        if ((n & 1) != 0)
            power = etch_mul_high(power, x) * 4;
        x = etch_mul_high(x, x) * 4;
    }
    return power >> 2;
}

/* Replaces rgb by what the sums and the material make of it. */
void etch_lamp_finish(const struct etch_lamps *lamps, const struct lamp_sum *sum, uint8_t rgb[3]);

#endif
